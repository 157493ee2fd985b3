#include "bench/report/report_text.h"

#include "bench/report/text_table.h"
#include "io/file/text.h"

#include <cmath>

namespace refraster::bench {
namespace {

constexpr const char* none = "-";

std::string counted(std::size_t count, const char* noun) {
  return with_commas(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string header(const SceneResult& scene) {
  std::string text = format("%s: %d x %d, ", scene.scene.c_str(), scene.width, scene.height);
  text += counted(static_cast<std::size_t>(scene.samples), "sample") + " a pixel, " + counted(scene.lights, "light");
  text += ", " + counted(scene.counts.triangles, "triangle") + ", " + with_commas(scene.counts.shaded) +
          " shaded pixels; " + counted(scene.repetitions, "repetition") + "\n";
  return text;
}

/// How far the middle half reaches, as a fraction of the median.
std::string middle(const Spread& spread) {
  return format("%.1f%%", 100 * (spread.upper - spread.lower) / spread.median);
}

std::string frames(const Run& run, const SceneResult& scene) {
  TextTable table({"", "threads", "frame ms", "quartiles", "CPU ms", "ns/px", "cycles/px", "GL/ours"});
  const auto row = [&](const std::string& name, int threads, const Spread& frame, const Spread& cpu,
                       const std::string& ratio) {
    const double ns = frame.median * 1e6 / scene.shaded();
    table.add({name, std::to_string(threads), format("%.3f", frame.median), middle(frame), format("%.3f", cpu.median),
               three_digits(ns), three_digits(ns * run.machine.time_stamp_ghz), ratio});
  };
  for (const PrecisionResult& precision : scene.precisions)
    row(precision.precision, precision.threads, precision.frame_ms, precision.cpu_ms,
        precision.opengl_ratio ? format("%.2f", precision.opengl_ratio->median) : none);
  for (const OpenGlResult& one : scene.opengl)
    row(one.renderer.substr(0, one.renderer.find(' ')), one.threads, one.frame_ms, one.cpu_ms, "");
  return table.text();
}

std::string split(const SceneResult& scene) {
  TextTable table({"ns/px of wall time", "threads", "transform", "bin", "coverage", "set-up", "interpolate", "light",
                   "resolve", "other"});
  for (const PrecisionResult& precision : scene.precisions) {
    std::vector<std::string> row = {precision.precision, std::to_string(precision.threads)};
    for (const auto& [name, part] : split_parts) {
      row.push_back(part_text(precision, part));
    }
    table.add(row);
  }
  return table.text();
}

std::string commands(const SceneResult& scene) {
  TextTable table({"the whole command, ms", "threads", "whole", "start", "read", "frame", "write", "CPU"});
  for (const CommandResult& command : scene.commands) {
    std::vector<std::string> row = {command.precision, std::to_string(command.threads)};
    for (const auto& [name, part] : command_parts) row.push_back(format("%.1f", (command.*part).median));
    table.add(row);
  }
  return table.text();
}

std::string costs(const SceneResult& scene) {
  TextTable table({"what adds how much", "ns of CPU", "lower quartile", "upper quartile"});
  const auto row = [&](const std::string& precision, const std::string& what, const Spread& ns) {
    const CostText cost = cost_text(ns);
    table.add({precision + ": " + what, cost.median, cost.lower, cost.upper});
  };
  for (const PrecisionResult& precision : scene.precisions) {
    for (const FunctionCost& cost : precision.functions)
      row(precision.precision, name_of(cost.function) + ", a fragment and light, one thread", cost.ns);
    if (!precision.marginal) continue;
    row(precision.precision, "one more light, a pixel", precision.marginal->light);
    if (precision.marginal->texture)
      row(precision.precision,
          precision.marginal->texture_change == TextureChange::removed ? "its textures, a pixel" : "a texture, a pixel",
          *precision.marginal->texture);
    if (precision.marginal->double_samples)
      row(precision.precision, "twice the samples, a pixel", *precision.marginal->double_samples);
  }
  return table.text();
}

std::string errors(const SceneResult& scene) {
  TextTable table({"error", "pixels", "max", "99.9%", "mean"});
  std::string more;
  for (const PrecisionError& precision : scene.errors) {
    if (precision.against_double) {
      const ImageError& error = *precision.against_double;
      const auto row = [&](const char* what, const ImageError::Figures& f) {
        table.add({precision.precision + what, with_commas(error.pixels), three_digits(f.max), three_digits(f.p99_9),
                   three_digits(f.mean)});
      };
      row(" against double, levels of 255", error.levels);
      row(" against double, relative", error.relative);
      more += precision.precision + ": in 8 bits " + with_commas(error.off_by_one) + " pixels are off by one, " +
              with_commas(error.off_by_more) + " by more\n";
    }
    const ExactError& exact = precision.against_exact;
    if (exact.pixels > 0)
      table.add({precision.precision + " against exact, relative", with_commas(exact.pixels),
                 three_digits(exact.max_relative), none, three_digits(exact.mean_relative)});
  }
  return table.text() + more;
}

/// What one of what grows costs: ns; of a shaded pixel, where each pixel meets all of them. Of threads: how many times
/// as fast they are as the first.
std::string each(const ScalingCurve& curve, const MeasuredPoint& one) {
  const double ms = one.frame_ms.median, ns = ms * 1e6 / one.point.n;
  switch (curve.growth) {
  case Growth::threads:
    return three_digits(curve.points.front().frame_ms.median / ms);
  case Growth::lights:
  case Growth::overdraw:
    return three_digits(ns / static_cast<double>(one.counts.shaded));
  case Growth::triangles:
  case Growth::pixels:
    return three_digits(ns);
  }
  return none;
}
const char* heading_of_each(Growth growth) {
  if (growth == Growth::threads) return "speed-up";
  return growth == Growth::lights || growth == Growth::overdraw ? "ns/px each" : "ns each";
}

std::string scaling(const ScalingCurve& curve) {
  std::string text = std::string(name_of(curve.growth)) + ", " + curve.precision;
  if (curve.growth == Growth::overdraw) text.append(", ").append(name_of(curve.order));
  if (const auto slope = curve.slope(); slope && curve.growth != Growth::threads) {
    text += format(": slope %.3f, standard error %.3f", slope->value, slope->error);
    if (const auto linear = curve.no_faster_than_linear())
      text += *linear ? ": no faster than linearly" : ": FASTER THAN LINEARLY";
  }
  if (curve.growth == Growth::overdraw) text += curve.same_fragments() ? "; no shading added" : "; SHADING ADDED";
  TextTable table({std::string(name_of(curve.growth)), "image", "threads", "frame ms", "quartiles",
                   heading_of_each(curve.growth), "fragments", "peak MB"});
  for (const MeasuredPoint& one : curve.points)
    table.add({with_commas(static_cast<unsigned long long>(one.point.n)),
               format("%dx%d", one.point.width, one.point.height), std::to_string(one.point.threads),
               format("%.3f", one.frame_ms.median), middle(one.frame_ms), each(curve, one),
               with_commas(one.counts.fragments),
               one.peak_memory_bytes ? format("%.1f", static_cast<double>(*one.peak_memory_bytes) * 1e-6) : none});
  return text + "\n" + table.text();
}

} // namespace

CostText cost_text(const Spread& difference) {
  if (!std::isfinite(difference.median)) return {none, none, none};
  if (!is_resolved(difference)) return {"< " + three_digits(cost_bound(difference)), none, none};
  const bool saves = difference.median < 0;
  const Spread cost = saves ? -difference : difference;
  return {(saves ? "saves " : "") + three_digits(cost.median), three_digits(cost.lower), three_digits(cost.upper)};
}

std::string part_text(const PrecisionResult& precision, double Split::*part) {
  const double ns = precision.split_ns.*part;
  if (!std::isfinite(ns)) return none; // of no pixel it is no number
  if (part == &Split::lighting && !(is_resolved(precision.lighting_ns) && ns > 0))
    return cost_text(precision.lighting_ns).median;
  return format("%.2f", ns);
}

std::string three_digits(double x) {
  if (!std::isfinite(x)) return none;
  const double size = std::abs(x);
  if (size != 0 && (size < 1e-3 || size >= 1e6)) return format("%.2g", x);
  return size >= 100  ? format("%.0f", x)
         : size >= 10 ? format("%.1f", x)
         : size >= 1  ? format("%.2f", x)
                      : format("%.3f", x);
}

std::string run_text(const Run& run) {
  std::string text = run.machine.cpu + ", " + counted(run.machine.usable_cpus.size(), "CPU") +
                     format(", load %.2f at the start, %.2f at the end\n", run.load_at_start[0], run.load_at_end[0]);
  for (const std::string& note : run.notes) text += "note: " + note + "\n";
  for (const SceneResult& scene : run.scenes) {
    text += "\n" + header(scene) + "\n" + frames(run, scene) + "\n" + split(scene);
    if (!scene.commands.empty()) text += "\n" + commands(scene);
    if (scene.precisions.front().marginal) text += "\n" + costs(scene);
    if (!scene.errors.empty()) text += "\n" + errors(scene);
  }
  for (const ScalingCurve& curve : run.scaling) text += "\n" + scaling(curve);
  return text;
}

} // namespace refraster::bench
