#include "bench/report/report_csv.h"

#include "io/file/build_info.h"

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <concepts>

namespace refraster::bench {
namespace {

/// A cell: words or a number.
class Cell {
public:
  Cell(std::string_view words) : text_(quoted(words)) {}
  Cell(const std::string& words) : Cell(std::string_view(words)) {}
  Cell(const char* words) : Cell(std::string_view(words)) {}
  Cell(double number) {
    if (!std::isfinite(number)) return;
    std::array<char, 32> digits;
    text_.assign(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
  }
  Cell(std::integral auto number) : text_(std::to_string(number)) {}
  Cell(const std::optional<std::uint64_t>& number) : text_(number ? std::to_string(*number) : "") {}

  const std::string& text() const { return text_; }

private:
  static std::string quoted(std::string_view words) {
    if (words.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(words);
    std::string result = "\"";
    for (const char c : words) result += c == '"' ? "\"\"" : std::string(1, c);
    return result + "\"";
  }
  std::string text_;
};

using Row = std::vector<Cell>;

class Csv {
public:
  explicit Csv(const Row& headings) : columns_(headings.size()) { add(headings); }
  void add(const Row& cells) {
    assert(cells.size() == columns_);
    for (std::size_t i = 0; i < cells.size(); ++i) text_ += (i == 0 ? "" : ",") + cells[i].text();
    text_ += '\n';
  }
  const std::string& text() const { return text_; }

private:
  std::size_t columns_;
  std::string text_;
};

void append(Row& row, const Row& more) {
  row.insert(row.end(), more.begin(), more.end());
}

Row spread_headings(const std::string& what) {
  return {what + "_min", what + "_lower", what + "_median", what + "_upper", what + "_max"};
}
Row spread_cells(const Spread& spread) {
  return {spread.min, spread.lower, spread.median, spread.upper, spread.max};
}

/// Numbers of a difference, whether it is larger than its spread, and if not, what the cost is below.
Row difference_headings() {
  Row headings = spread_headings("ns");
  append(headings, {"resolved", "below_ns"});
  return headings;
}
Row difference_cells(const Spread& difference) {
  Row cells = spread_cells(difference);
  const bool resolved = is_resolved(difference);
  append(cells, {resolved ? "yes" : "no", resolved ? Cell("") : Cell(cost_bound(difference))});
  return cells;
}

Row scene_headings() {
  return {"scene", "width", "height", "samples"};
}
Row scene_cells(const SceneResult& scene) {
  return {scene.scene, scene.width, scene.height, scene.samples};
}

std::string frames(const Run& run) {
  Row headings = scene_headings();
  append(headings, {"lights", "triangles", "shaded_pixels", "drawn_by", "threads", "repetitions"});
  append(headings, spread_headings("frame_ms"));
  append(headings, spread_headings("cpu_ms"));
  append(headings, {"wall_ns_per_pixel", "reference_cycles_per_pixel", "opengl_ratio"});
  Csv csv(headings);
  for (const SceneResult& scene : run.scenes) {
    const auto add = [&](const std::string& who, int threads, const Spread& frame, const Spread& cpu,
                         const Cell& ratio) {
      Row row = scene_cells(scene);
      append(row, {scene.lights, scene.counts.triangles, scene.counts.shaded, who, threads, scene.repetitions});
      append(row, spread_cells(frame));
      append(row, spread_cells(cpu));
      const double ns = frame.median * 1e6 / scene.shaded();
      append(row, {ns, ns * run.machine.time_stamp_ghz, ratio});
      csv.add(row);
    };
    for (const PrecisionResult& precision : scene.precisions)
      add(precision.precision, precision.threads, precision.frame_ms, precision.cpu_ms,
          precision.opengl_ratio ? Cell(precision.opengl_ratio->median) : Cell(""));
    for (const OpenGlResult& one : scene.opengl) add(one.renderer, one.threads, one.frame_ms, one.cpu_ms, "");
  }
  return csv.text();
}

std::string split(const Run& run) {
  Row headings = scene_headings();
  append(headings, {"precision", "threads"});
  for (const auto& [name, part] : split_parts) headings.emplace_back(std::string(name) + "_ns");
  append(headings, {"fragment_functions_resolved", "fragment_functions_below_ns"});
  Csv csv(headings);
  for (const SceneResult& scene : run.scenes)
    for (const PrecisionResult& precision : scene.precisions) {
      Row row = scene_cells(scene);
      append(row, {precision.precision, precision.threads});
      for (const auto& [name, part] : split_parts) row.emplace_back(precision.split_ns.*part);
      const Row difference = difference_cells(precision.lighting_ns);
      append(row, {difference.end() - 2, difference.end()});
      csv.add(row);
    }
  return csv.text();
}

std::string commands(const Run& run) {
  Row headings = scene_headings();
  append(headings, {"precision", "threads", "repetitions"});
  for (const auto& [name, part] : command_parts) append(headings, spread_headings(std::string(name) + "_ms"));
  Csv csv(headings);
  for (const SceneResult& scene : run.scenes)
    for (const CommandResult& command : scene.commands) {
      Row row = scene_cells(scene);
      append(row, {command.precision, command.threads, command.repetitions});
      for (const auto& [name, part] : command_parts) append(row, spread_cells(command.*part));
      csv.add(row);
    }
  return csv.text();
}

std::string costs(const Run& run) {
  Row headings = scene_headings();
  append(headings, {"precision", "threads", "what", "of"});
  append(headings, difference_headings());
  Csv csv(headings);
  for (const SceneResult& scene : run.scenes)
    for (const PrecisionResult& precision : scene.precisions) {
      const auto add = [&](const std::string& what, const char* of, const Spread& ns) {
        Row row = scene_cells(scene);
        append(row, {precision.precision, precision.threads, what, of});
        append(row, difference_cells(ns));
        csv.add(row);
      };
      for (const FunctionCost& cost : precision.functions) add(name_of(cost.function), "fragment and light", cost.ns);
      if (!precision.marginal) continue;
      add("one more light", "pixel", precision.marginal->light);
      if (precision.marginal->texture)
        add(precision.marginal->texture_change == TextureChange::removed ? "its textures" : "a texture", "pixel",
            *precision.marginal->texture);
      if (precision.marginal->double_samples) add("twice the samples", "pixel", *precision.marginal->double_samples);
    }
  return csv.text();
}

std::string errors(const Run& run) {
  Row headings = scene_headings();
  append(headings, {"precision", "against", "unit", "pixels", "max", "p99_9", "mean", "off_by_one", "off_by_more"});
  Csv csv(headings);
  for (const SceneResult& scene : run.scenes)
    for (const PrecisionError& error : scene.errors) {
      const auto add = [&](const Row& cells) {
        Row row = scene_cells(scene);
        row.emplace_back(error.precision);
        append(row, cells);
        csv.add(row);
      };
      if (error.against_double) {
        const ImageError& image = *error.against_double;
        const ImageError::Figures &levels = image.levels, &relative = image.relative;
        add({"double", "levels", image.pixels, levels.max, levels.p99_9, levels.mean, image.off_by_one,
             image.off_by_more});
        add({"double", "relative", image.pixels, relative.max, relative.p99_9, relative.mean, "", ""});
      }
      const ExactError& exact = error.against_exact;
      if (exact.pixels > 0)
        add({"exact", "relative", exact.pixels, exact.max_relative, "", exact.mean_relative, "", ""});
    }
  return csv.text();
}

std::string scaling(const Run& run) {
  Row headings = {"growth", "order", "precision", "n", "width", "height", "threads", "frames"};
  append(headings, spread_headings("frame_ms"));
  append(headings, spread_headings("cpu_ms"));
  append(headings, {"peak_memory_bytes", "triangles", "shaded_pixels", "fragments"});
  Csv csv(headings);
  for (const ScalingCurve& curve : run.scaling)
    for (const MeasuredPoint& one : curve.points) {
      Row row = {name_of(curve.growth), curve.growth == Growth::overdraw ? name_of(curve.order) : std::string_view(),
                 curve.precision,       one.point.n,
                 one.point.width,       one.point.height,
                 one.point.threads,     one.frames};
      append(row, spread_cells(one.frame_ms));
      append(row, spread_cells(one.cpu_ms));
      append(row, {one.peak_memory_bytes, one.counts.triangles, one.counts.shaded, one.counts.fragments});
      csv.add(row);
    }
  return csv.text();
}

/// What a reader of the other tables must know.
std::string machine(const Run& run) {
  Csv csv({"what", "value"});
  const Machine& machine = run.machine;
  const BuildInfo build = this_build();
  csv.add({"command", run.command});
  csv.add({"started", run.started});
  csv.add({"ended", run.ended});
  csv.add({"refraster", build.version});
  csv.add({"compiler", build.compiler});
  csv.add({"isa", build.isa});
  csv.add({"revision", this_origin().revision});
  csv.add({"cpu", machine.cpu});
  csv.add({"cpus", machine.cpus});
  csv.add({"memory_bytes", machine.memory_bytes});
  csv.add({"kernel", machine.kernel});
  csv.add({"virtualized", machine.virtualized});
  csv.add({"governor", machine.governor});
  csv.add({"time_stamp_ghz", machine.time_stamp_ghz});
  csv.add({"load_at_start", run.load_at_start[0]});
  csv.add({"load_at_end", run.load_at_end[0]});
  for (const std::string& note : run.notes) csv.add({"note", note});
  return csv.text();
}

} // namespace

std::vector<CsvTable> csv_tables(const Run& run) {
  constexpr std::string (*tables[])(const Run&) = {frames, split, commands, costs, errors, scaling, machine};
  static_assert(std::size(tables) == std::size(csv_file_names));
  std::vector<CsvTable> all;
  for (std::size_t i = 0; i < std::size(tables); ++i) all.push_back({csv_file_names[i], tables[i](run)});
  return all;
}

} // namespace refraster::bench
