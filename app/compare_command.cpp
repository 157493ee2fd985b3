// refraster compare A B

#include "app/arguments.h"
#include "app/command.h"
#include "app/memory_limit.h"
#include "app/output.h"
#include "app/progress_line.h"
#include "io/image_file.h"
#include "verify/compare_report.h"
#include "verify/flip.h"
#include "verify/heat_legend.h"
#include "verify/image_pair.h"
#include "verify/limits_file.h"

#include <iostream>
#include <memory>

namespace refraster {
namespace {

struct CompareArguments {
  std::string a, b, diff, json, limits_file;
  CompareLimits limits;
  std::uint64_t max_memory = 0;
  enum class Flip { no, yes } flip = Flip::no;
};

/// Nothing where it is not defined: for values that are not levels, or not red, green and blue.
std::optional<double> flip_of(const ImagePair& images) {
  if (images.unit != CompareUnit::levels || images.a.channels != 3) return std::nullopt;
  return mean_flip(images.a, images.b);
}

/// Those of the file, where the command line does not give them.
CompareLimits all_limits(const CompareArguments& arguments) {
  CompareLimits limits = arguments.limits;
  if (arguments.limits_file.empty()) return limits;
  const CompareLimits kept = read_limits(arguments.limits_file);
  if (!limits.max_abs) limits.max_abs = kept.max_abs;
  if (!limits.max_rms) limits.max_rms = kept.max_rms;
  if (!limits.max_count) limits.max_count = kept.max_count;
  return limits;
}

ExitCode run(const CompareArguments& arguments) {
  const MemoryBudget memory = hold_to(arguments.max_memory, 1);
  check_different({arguments.diff, arguments.json}, {arguments.a, arguments.b, arguments.limits_file});
  if (!arguments.diff.empty()) check_writable(arguments.diff);
  if (!arguments.json.empty()) check_writable(arguments.json);
  const CompareLimits limits = all_limits(arguments);
  auto line = std::make_unique<ProgressLine>("comparing");
  const ImagePair images = read_image_pair(arguments.a, arguments.b, memory);
  const Comparison found = compare(images.a, images.b, images.unit, limits);
  if (!arguments.diff.empty()) write_png(arguments.diff, with_legend(heat_image(images.a, images.b, found), found));
  const ComparisonReport report{arguments.a, arguments.b, limits, found,
                                arguments.flip == CompareArguments::Flip::yes ? flip_of(images) : std::nullopt};
  line.reset(); // before anything is printed
  if (!arguments.json.empty()) write_text(arguments.json, comparison_json(report));
  if (arguments.json != standard_output) std::cout << comparison_text(report);
  return found.same ? ExitCode::ok : ExitCode::differ;
}

} // namespace

void add_compare(CLI::App& program, Action& chosen) {
  CLI::App& command = add_sub_command(program, "compare", "How far two images are apart, and where");
  const auto arguments = std::make_shared<CompareArguments>();
  CompareArguments& a = *arguments;
  command.add_option("a", a.a, "image, .png .hdr .pfm or .exr")->required()->type_name("A");
  command.add_option("b", a.b, "image of the same size; differences are b - a")->required()->type_name("B");
  command
      .add_option("--diff", a.diff,
                  "write a heat image: black where equal, the lighter the more different; with a legend below")
      ->type_name("FILE.png");
  command.add_option("--json", a.json, "write the numbers as JSON; - is standard output")->type_name("FILE");
  add_parsed_option(command, "--max-abs", a.limits.max_abs, distance_from, "X", "a number >= 0",
                    "largest difference of a value that is allowed");
  add_parsed_option(command, "--max-rms", a.limits.max_rms, distance_from, "X", "a number >= 0",
                    "largest root mean square difference that is allowed");
  add_parsed_option(command, "--max-count", a.limits.max_count, count_from, "N", "a whole number >= 0",
                    "so many pixels may differ by more than --max-abs, or at all");
  command.add_flag_callback(
      "--flip", [&a] { a.flip = CompareArguments::Flip::yes; },
      "also say how different two 8-bit RGB images look to a person, 0 to 1 (LDR-FLIP); judges nothing");
  command
      .add_option("--limits", a.limits_file, "JSON file with max_abs, max_rms, max_count; options above it go first")
      ->type_name("FILE");
  add_memory_option(command, a.max_memory);
  command.footer("Two 8-bit images are compared in levels, 0 to 255; others in values, where a level is 1/255.\n"
                 "Without a limit, all values must be the same. NaN equals nothing.\n"
                 "Exit code 0: the same within the limits, 1: not, 3: not comparable.");
  command.final_callback([&chosen, arguments] {
    if (!arguments->diff.empty() && image_format(arguments->diff) != ImageFormat::png)
      throw CLI::ValidationError("--diff", "found \"" + arguments->diff + "\", expected a name ending in .png");
    chosen = [arguments] { return run(*arguments); };
  });
}

} // namespace refraster
