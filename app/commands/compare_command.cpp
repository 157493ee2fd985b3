// refraster compare A B

#include <refraster/files.h>
#include <refraster/notes.h>

#include "app/arguments.h"
#include "app/command.h"
#include "app/diagnostics.h"
#include "app/memory_limit.h"
#include "app/options/shared_options.h"
#include "app/output.h"
#include "app/progress_line.h"
#include "app/usage_error.h"
#include "verify/compare/compare_files.h"
#include "verify/compare/compare_report.h"
#include "verify/compare/heat_legend.h"
#include "verify/compare/limits_file.h"

#include <iostream>
#include <memory>

namespace refraster {
namespace {

struct CompareArguments {
  std::string a, b, scene, diff, html, json, limits_file, unit = "levels";
  CompareLimits limits;
  PairRequest pair;
  std::optional<double> heat_max; // levels
  SceneOptions reading;
  Diagnostics diagnostics;
  std::uint64_t max_memory = 0;
  enum class Flip { no, yes } flip = Flip::no;

  CompareUnit compare_unit() const { return unit == "levels" ? CompareUnit::levels : CompareUnit::values; }
};

/// A number of levels above 0.
std::optional<double> heat_max_from(std::string_view text) {
  const std::optional<double> levels = distance_from(text);
  return levels && *levels > 0 ? levels : std::nullopt;
}

/// Those of the file, where the command line does not give them.
CompareLimits all_limits(const CompareArguments& arguments) {
  CompareLimits limits = arguments.limits;
  if (arguments.limits_file.empty()) return limits;
  const CompareLimits from_file = read_limits(arguments.limits_file, arguments.compare_unit());
  if (!limits.max_abs) limits.max_abs = from_file.max_abs;
  if (!limits.max_rms) limits.max_rms = from_file.max_rms;
  if (!limits.max_count) limits.max_count = from_file.max_count;
  return limits;
}

/// A limit that no two images of 8 or 16 bits can exceed judges nothing.
void note_on_limits(const CompareLimits& limits, const ImagePair& images, CompareUnit unit,
                    const Diagnostics& diagnostics) {
  const bool bounded = images.precision_a.saturates() && images.precision_b.saturates();
  if (bounded && limits.max_abs && *limits.max_abs >= full_range(unit))
    print_note("no two images of 8 or 16 bits differ by more than --max-abs", diagnostics);
}

ExitCode run(const CompareArguments& arguments) {
  const MemoryBudget memory = set_memory_limit(arguments.max_memory, arguments.scene.empty() ? 1 : 0);
  const std::vector<std::string> outputs = {arguments.diff, arguments.html, arguments.json};
  check_different(outputs, {arguments.a, arguments.b, arguments.limits_file, arguments.scene});
  for (const std::string& path : outputs)
    if (!path.empty()) check_writable(path);
  prepare_cache(arguments.reading.mesh_cache);
  const CompareUnit unit = arguments.compare_unit();
  const CompareLimits limits = all_limits(arguments);
  const bool quiet = arguments.diagnostics.verbosity == Verbosity::quiet;
  std::unique_ptr<ProgressLine> line;
  if (!quiet) line = std::make_unique<ProgressLine>("comparing");
  CompareRequest request{.a = arguments.a,
                         .b = arguments.b,
                         .pair = arguments.pair,
                         .limits = limits,
                         .unit = unit,
                         .scene = arguments.scene,
                         .memory = memory};
  SceneOptions reading = arguments.reading;
  reading.memory = memory;
  if (!arguments.scene.empty()) request.seen = objects_of_scene(arguments.scene, reading, arguments.a);
  FileComparison compared = compare_files(request);
  const ImagePair& images = compared.images;
  ComparisonReport& report = compared.report;
  if (arguments.flip == CompareArguments::Flip::yes) report.mean_flip = flip_of(compared);
  if (!arguments.diff.empty()) {
    std::optional<double> asked = arguments.heat_max;
    if (asked) *asked *= full_range(unit) / 255;
    const double end = heat_ramp_end(report.found, asked);
    write_image(arguments.diff, with_legend(heat_image(images.a, images.b, compared.scale, end), report.found, end));
  }
  if (!arguments.html.empty()) write_text(arguments.html, comparison_html(compared, arguments.html, memory));
  line.reset(); // before anything is printed
  print_file_notes(report.notes, arguments.diagnostics);
  note_on_limits(limits, images, unit, arguments.diagnostics);
  if (!arguments.json.empty()) write_text(arguments.json, comparison_json(report));
  if (arguments.json != standard_output && !quiet) std::cout << comparison_text(report);
  return report.found.same ? ExitCode::ok : ExitCode::differ;
}

} // namespace

Command compare_command() {
  const auto arguments = std::make_shared<CompareArguments>();
  CompareArguments& a = *arguments;
  return {
      .name = "compare",
      .meaning = "How far two images are apart, and where",
      .groups =
          {{"Images",
            {argument("A", a.a, "image: " + readable_formats()),
             argument("B", a.b, "image of the same size; differences are b - a"),
             alpha_option(a.pair.alpha, a.pair.background, ComparedAlpha::offered),
             premultiplied_option(a.pair.encoding),
             text_option("--layer", "NAME", a.pair.layer,
                         "of .exr files: the layer or the channel that is compared, as N or Z")}},
           {"Limits",
            {parsed_option("--max-abs", "X", a.limits.max_abs, distance_from, "a number >= 0",
                           "largest difference of a value that is allowed, in --unit"),
             parsed_option("--max-rms", "X", a.limits.max_rms, distance_from, "a number >= 0",
                           "largest root mean square difference that is allowed, in --unit"),
             parsed_option("--max-count", "N", a.limits.max_count, count_from, "a whole number >= 0",
                           "so many pixels may differ by more than --max-abs, or at all"),
             choice_option("--unit", a.unit, {"levels", "values"},
                           "of limits and report: levels of 1/255, whatever the files hold; or values, 1 being white"),
             file_option("--limits", "FILE", a.limits_file,
                         "JSON file with max_abs, max_rms, max_count, unit; options above it go first")}},
           {"Scene",
            {file_option("--scene", "SCENE", a.scene,
                         "the scene that both images show: clusters are named by its objects, as its camera sees them"),
             outside_option(a.reading.outside), cache_option(a.reading.mesh_cache)}},
           {"Report",
            {file_option("--diff", "FILE.png", a.diff,
                         "write a heat image: black where equal, the lighter the more different; with a legend below"),
             parsed_option("--heat-max", "LEVELS", a.heat_max, heat_max_from, "a number > 0",
                           "difference at the end of --diff's ramp, so that two heat images can be compared"),
             file_option("--html", "FILE", a.html,
                         "write a page to look at both images pixel by pixel; one file, without network"),
             file_option("--json", "FILE", a.json, "write the numbers as JSON; - is standard output"),
             flag(
                 "--flip", [&a] { a.flip = CompareArguments::Flip::yes; },
                 "also say how different two images of 8 or 16 bits look to a person, 0 to 1 (LDR-FLIP); judges "
                 "nothing"),
             memory_option(a.max_memory),
             quiet_option(a.diagnostics,
                          "print errors only: no report, progress or notes; the exit code says the result")}}},
      .notes = {"Differences and limits are in levels, 1/255, or with --unit values in values. Without a limit, all "
                "values must be the same. NaN equals nothing.",
                "Exit code 0: the same within the limits, 1: not, 3: not comparable."},
      .finish = [arguments]() -> Action {
        if (!arguments->diff.empty()) check_extension("--diff", arguments->diff, {rgb8_image});
        if (arguments->heat_max && arguments->diff.empty())
          throw UsageError("--heat-max", "found no --diff, whose ramp it ends");
        return [arguments] { return run(*arguments); };
      }};
}

} // namespace refraster
