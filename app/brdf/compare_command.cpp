// refraster brdf compare A B

#include "app/arguments.h"
#include "app/brdf/brdf_commands.h"
#include "app/memory_limit.h"
#include "app/options/shared_options.h"
#include "app/output.h"
#include "app/progress_line.h"
#include "brdf/comparison.h"

#include <iostream>
#include <memory>

namespace refraster {
namespace {

struct BrdfCompareArguments {
  std::string a, b, json;
  MerlLookup lookup = MerlLookup::trilinear;
  BrdfLimits limits;
  Diagnostics diagnostics;
  std::uint64_t max_memory = 0;
};

ExitCode run(const BrdfCompareArguments& arguments) {
  set_memory_limit(arguments.max_memory, 0);
  check_different({arguments.json}, {arguments.a, arguments.b});
  if (!arguments.json.empty()) check_writable(arguments.json);
  const Brdf a = read_brdf(arguments.a, arguments.lookup, arguments.diagnostics);
  const Brdf b = read_brdf(arguments.b, arguments.lookup, arguments.diagnostics);
  auto progress = progress_line(arguments.diagnostics, "comparing");
  const BrdfComparisonReport report{a, b, arguments.limits, compare_brdfs(a, b)};
  progress.reset();
  if (!arguments.json.empty()) write_text(arguments.json, comparison_json(report));
  if (arguments.json != standard_output && arguments.diagnostics.verbosity != Verbosity::quiet)
    std::cout << comparison_text(report);
  return is_within(arguments.limits, report.found) ? ExitCode::ok : ExitCode::differ;
}

Option limit_option(const std::string& name, std::optional<double>& limit, const std::string& meaning) {
  return parsed_option(name, "X", limit, distance_from, "a number >= 0",
                       "largest root mean square of " + meaning + " that is allowed, over all pairs");
}

} // namespace

Command brdf_compare_command() {
  const auto arguments = std::make_shared<BrdfCompareArguments>();
  BrdfCompareArguments& a = *arguments;
  std::vector<std::string> notes = {"Exit code 0: the same within the limits, 1: not. Without a limit, all values must "
                                    "be the same. docs/brdf.md says what each error is, and where it is from."};
  for (std::string& note : model_notes()) notes.push_back(std::move(note));
  return {
      .name = "compare",
      .meaning = "How far two reflectances are apart, and where",
      .groups = {{"Reflectances",
                  {brdf_argument("A", a.a, "the one that is right"), brdf_argument("B", a.b, "the other"),
                   lookup_option(a.lookup)}},
                 {"Limits",
                  {limit_option("--max-rms", a.limits.max_rms, "b - a, in 1/sr"),
                   limit_option("--max-cosine-rms", a.limits.max_cosine_rms, "(b - a) cos"),
                   limit_option("--max-log-rms", a.limits.max_log_rms, "ln(1 + b cos) - ln(1 + a cos)"),
                   limit_option("--max-cube-root-rms", a.limits.max_cube_root_rms, "the cube roots of b cos, a cos")}},
                 {"Report",
                  {file_option("--json", "FILE", a.json, "write the numbers as JSON; - is standard output"),
                   memory_option(a.max_memory),
                   quiet_option(a.diagnostics,
                                "print errors only: no report or progress; the exit code says the result")}}},
      .notes = notes,
      .finish = [arguments]() -> Action {
        check_brdf_word("A", arguments->a);
        check_brdf_word("B", arguments->b);
        return [arguments] { return run(*arguments); };
      }};
}

} // namespace refraster
