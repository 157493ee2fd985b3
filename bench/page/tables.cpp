#include "bench/page/tables.h"

#include "bench/page/charts.h"
#include "bench/report/report_text.h"
#include "io/file/build_info.h"
#include "io/file/text.h"
#include "io/html/html_table.h"

namespace refraster::bench {
namespace {

std::string plus_minus(const Spread& spread) {
  return format("± %.1f %%", 50 * (spread.upper - spread.lower) / spread.median);
}

} // namespace

std::string frames_table(const Run& run) {
  HtmlTable table({"scene", "pixels", "", "threads", "ms", "", "CPU ms", "ns/px", "cycles/px", "OpenGL ÷ ours"}, 3);
  for (const SceneResult& scene : run.scenes) {
    auto group = HtmlTable::Group::first;
    const auto row = [&](const std::string& who, int threads, const Spread& frame, const Spread& cpu,
                         const std::string& ratio) {
      const bool first = group == HtmlTable::Group::first;
      const double ns = frame.median * 1e6 / scene.shaded();
      table.add({first ? short_name(scene) : "", first ? format("%d × %d", scene.width, scene.height) : "", who,
                 std::to_string(threads), format("%.2f", frame.median), plus_minus(frame), format("%.2f", cpu.median),
                 three_digits(ns), three_digits(ns * run.machine.time_stamp_ghz), ratio},
                group);
      group = HtmlTable::Group::same;
    };
    for (const PrecisionResult& precision : scene.precisions)
      row(precision.precision, precision.threads, precision.frame_ms, precision.cpu_ms,
          precision.opengl_ratio ? format("%.2f", precision.opengl_ratio->median) : "");
    for (const OpenGlResult& one : scene.opengl)
      row(one.renderer.substr(0, one.renderer.find(' ')), one.threads, one.frame_ms, one.cpu_ms, "");
  }
  return table.html();
}

std::string commands_table(const Run& run) {
  HtmlTable table({"scene", "pixels", "", "threads", "ms", "", "start", "read", "frame", "write", "CPU ms"}, 3);
  for (const SceneResult& scene : run.scenes) {
    auto group = HtmlTable::Group::first;
    for (const CommandResult& command : scene.commands) {
      const bool first = group == HtmlTable::Group::first;
      std::vector<std::string> row = {first ? short_name(scene) : "",
                                      first ? format("%d × %d", scene.width, scene.height) : "", command.precision,
                                      std::to_string(command.threads)};
      for (const auto& [name, part] : command_parts) {
        row.push_back(format("%.1f", (command.*part).median));
        if (part == &CommandResult::whole_ms) row.push_back(plus_minus(command.whole_ms));
      }
      table.add(row, group);
      group = HtmlTable::Group::same;
    }
  }
  return table.html();
}

std::string errors_table(const Run& run) {
  HtmlTable table(
      {"scene", "precision", "exact: mean", "max", "double, levels: max", "99.9 %", "mean", "off by one", "by more"},
      2);
  for (const SceneResult& scene : run.scenes) {
    auto group = HtmlTable::Group::first;
    for (const PrecisionError& error : scene.errors) {
      const ExactError& exact = error.against_exact;
      std::vector<std::string> row = {group == HtmlTable::Group::first ? label(run, scene) : "", error.precision,
                                      exact.pixels > 0 ? format("%.1e", exact.mean_relative) : "–",
                                      exact.pixels > 0 ? format("%.1e", exact.max_relative) : "–"};
      if (error.against_double) {
        const ImageError& image = *error.against_double;
        const double percent = 100.0 / static_cast<double>(image.pixels);
        for (const double level : {image.levels.max, image.levels.p99_9, image.levels.mean})
          row.push_back(three_digits(level));
        for (const std::uint64_t count : {image.off_by_one, image.off_by_more})
          row.push_back(count == 0 ? "0" : format("%.2g %%", static_cast<double>(count) * percent));
      } else {
        row.insert(row.end(), 5, "–");
      }
      table.add(row, group);
      group = HtmlTable::Group::same;
    }
  }
  return table.html();
}

std::string costs_table(const Run& run) {
  HtmlTable table({"scene", "precision", "what", "of", "ns", "lower", "upper quartile"}, 4);
  for (const SceneResult& scene : run.scenes) {
    auto group = HtmlTable::Group::first;
    for (const PrecisionResult& precision : scene.precisions) {
      const auto row = [&](const std::string& what, const Spread& ns, const char* of) {
        const CostText cost = cost_text(ns);
        table.add({group == HtmlTable::Group::first ? label(run, scene) : "", precision.precision, what, of,
                   cost.median, cost.lower, cost.upper},
                  group);
        group = HtmlTable::Group::same;
      };
      for (const FunctionCost& cost : precision.functions)
        row(name_of(cost.function), cost.ns, "a fragment and light, one thread");
      if (!precision.marginal) continue;
      row("one more light", precision.marginal->light, "a shaded pixel");
      if (precision.marginal->texture)
        row(precision.marginal->texture_change == TextureChange::removed ? "its textures" : "a texture",
            *precision.marginal->texture, "a shaded pixel");
      if (precision.marginal->double_samples)
        row("twice the samples", *precision.marginal->double_samples, "a shaded pixel");
    }
  }
  return table.html();
}

std::string scaling_table(std::span<const ScalingCurve* const> curves) {
  const Growth growth = curves.front()->growth;
  std::vector<std::string> headings = {"precision"};
  if (growth == Growth::overdraw) headings.emplace_back("order");
  const std::size_t words = headings.size();
  headings.insert(headings.end(), {"from", "to", "ms", "to", "peak MB"});
  if (growth == Growth::threads) headings.emplace_back("times as fast");
  else headings.insert(headings.end(), {"slope", "steepest step", "at most linear"});
  if (growth == Growth::overdraw) headings.emplace_back("shading added");
  HtmlTable table(headings, words);
  for (const ScalingCurve* const curve : curves) {
    const MeasuredPoint &first = curve->points.front(), &last = curve->points.back();
    std::vector<std::string> row = {curve->precision};
    if (growth == Growth::overdraw) row.emplace_back(name_of(curve->order));
    for (const MeasuredPoint* const point : {&first, &last})
      row.push_back(with_commas(static_cast<unsigned long long>(point->point.n)));
    for (const MeasuredPoint* const point : {&first, &last}) row.push_back(three_digits(point->frame_ms.median));
    row.push_back(last.peak_memory_bytes ? three_digits(static_cast<double>(*last.peak_memory_bytes) * 1e-6) : "–");
    if (growth == Growth::threads) {
      row.push_back(three_digits(first.frame_ms.median / last.frame_ms.median));
    } else {
      const auto slope = curve->slope();
      const auto steepest = curve->steepest();
      const auto linear = curve->no_faster_than_linear();
      row.push_back(slope ? format("%.3f ± %.3f", slope->value, slope->error) : "–");
      row.push_back(steepest ? format("%.3f", steepest->slope) : "–");
      row.emplace_back(linear ? *linear ? "yes" : "no" : "–");
    }
    if (growth == Growth::overdraw) row.emplace_back(curve->same_fragments() ? "none" : "some");
    table.add(row);
  }
  return table.html();
}

std::string facts_table(const Run& run) {
  std::string html = "<table class=\"facts\">\n";
  const auto fact = [&](const char* name, const std::string& value) {
    html += std::string("<tr><td class=\"left\">") + name + "</td><td class=\"left\">" +
            (value.empty() ? "unknown" : escaped(value)) + "</td></tr>\n";
  };
  const Machine& machine = run.machine;
  std::string caches, cpus;
  for (const std::string& cache : machine.caches) caches += (caches.empty() ? "" : ", ") + cache;
  for (const int cpu : machine.usable_cpus) cpus += (cpus.empty() ? "" : ", ") + std::to_string(cpu);
  fact("processor", machine.cpu);
  fact("CPUs", std::to_string(machine.cpus) + " online; threads were pinned, one each, to " + cpus);
  fact("caches", caches);
  fact("memory", format("%.1f GB", static_cast<double>(machine.memory_bytes) * 1e-9));
  fact("virtual machine", machine.virtualized);
  fact("kernel", machine.kernel);
  fact("clock governor", machine.governor);
  fact("time stamp counter", format("%.3f GHz", machine.time_stamp_ghz));
  fact("load average", format("%.2f at the start, %.2f at the end", run.load_at_start[0], run.load_at_end[0]));
  const BuildInfo build = this_build();
  const Origin origin = this_origin();
  fact("build", build.version + ", " + build.compiler + ", " + build.type + ", " + build.isa);
  fact("flags", origin.flags);
  fact("revision", origin.revision);
  fact("repetitions", format("%d to warm up; then at least %d, and until %g s have passed for a scene", run.warm_up,
                             run.min_repetitions, run.seconds));
  fact("time", run.started + " to " + run.ended);
  return html + "</table>\n";
}

} // namespace refraster::bench
