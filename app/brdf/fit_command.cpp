// refraster brdf fit TABLE --to MODEL

#include <refraster/files.h>

#include "app/brdf/brdf_commands.h"
#include "app/memory_limit.h"
#include "app/options/shared_options.h"
#include "app/output.h"
#include "app/progress_line.h"
#include "app/usage_error.h"
#include "brdf/comparison.h"
#include "brdf/fit/fit.h"
#include "brdf/page/page.h"

#include <filesystem>
#include <iostream>
#include <memory>

namespace refraster {
namespace {

struct FitArguments {
  std::string word, model, output, json, html;
  int lobes = 1;
  MerlLookup lookup = MerlLookup::trilinear;
  Diagnostics diagnostics;
  std::uint64_t max_memory = 0;
};

/// "out/fit.json" gives "out/fit.binary".
std::string table_path(const FitArguments& arguments) {
  return std::filesystem::path(arguments.output).replace_extension(".binary").string();
}

/// Whether -o writes a table beside the material: a scene names no sum, and no formula that is no fragment function.
bool needs_table(const BrdfFit& fit) {
  return !is_fragment_function(fit);
}

void write_material(const FitArguments& arguments, const BrdfFit& fit) {
  const std::string table = table_path(arguments);
  if (needs_table(fit)) {
    check_different({table}, {arguments.word, arguments.output});
    const Brdf fitted("", fit.lobes);
    write_merl(table, merl_table_from([&](const Double3&, const Double3& i, const Double3& o) {
                 return fitted.value({i, o}).f;
               }));
  }
  write_text(arguments.output, material_json(fit, std::filesystem::path(table).filename().string()));
}

std::string page_of(const Brdf& brdf, const BrdfFit& fit) {
  const Brdf fitted("fit: " + fit.model, fit.lobes);
  BrdfPage page{{brdf, &fitted}, "brdf fit " + short_label(brdf) + " to " + fit.model, page_facts(brdf, "a")};
  for (auto& row : page_facts(fitted, "b")) page.facts.push_back(std::move(row));
  for (const std::string& doubt : fit.doubts) page.facts.emplace_back("poor", doubt);
  page.comparison = fit_text(brdf, fit) + "\n" + comparison_text({brdf, fitted, {}, compare_brdfs(brdf, fitted)});
  return brdf_page_html(page);
}

ExitCode run(const FitArguments& arguments) {
  set_memory_limit(arguments.max_memory, 0);
  const std::vector<std::string> outputs = {arguments.output, arguments.json, arguments.html};
  check_different(outputs, {arguments.word});
  for (const std::string& path : outputs)
    if (!path.empty()) check_writable(path);
  const Brdf brdf = read_brdf(arguments.word, arguments.lookup, arguments.diagnostics);
  auto progress = progress_line(arguments.diagnostics, "fitting");
  const BrdfFit fit = fit_or_refuse(brdf, arguments.model, arguments.lobes);
  progress.reset();
  for (const std::string& doubt : fit.doubts) print_note("the fit is poor: " + doubt, arguments.diagnostics);
  if (!arguments.json.empty()) write_text(arguments.json, fit_json(brdf, fit));
  if (!arguments.output.empty()) write_material(arguments, fit);
  if (!arguments.html.empty()) write_text(arguments.html, page_of(brdf, fit));
  if (arguments.json != standard_output && arguments.output != standard_output && arguments.html != standard_output &&
      arguments.diagnostics.verbosity != Verbosity::quiet)
    std::cout << fit_text(brdf, fit);
  return ExitCode::ok;
}

std::vector<std::string> model_words() {
  std::vector<std::string> words;
  for (const FittedModel& model : fitted_models) words.emplace_back(model.name);
  return words;
}

} // namespace

Command brdf_fit_command() {
  const auto arguments = std::make_shared<FitArguments>();
  FitArguments& a = *arguments;
  std::vector<std::string> notes = {
      "A table is written beside the material, as FILE.binary, where a scene has no fragment function for the fit: of "
      "several lobes, and of ggx-conductor and ggx-dielectric.",
      "A fit that is poor is noted, and the exit code is 0. docs/brdf.md"};
  for (std::string& note : model_notes()) notes.push_back(std::move(note));
  return {.name = "fit",
          .meaning = "Parameters of a model that come nearest to a reflectance",
          .groups = {{"Reflectance",
                      {brdf_argument("BRDF", a.word, "what to fit"),
                       choice_option("--to", a.model, model_words(), "the model").required(),
                       number_choice_option("--lobes", a.lobes, {1, 2, 3}, "how many highlights of it are added up"),
                       lookup_option(a.lookup)}},
                     {"Report",
                      {file_option("-o,--output", "FILE.json", a.output,
                                   "write the keys `fragment_function` and `material` of an object of a scene file; - "
                                   "is standard output"),
                       file_option("--json", "FILE", a.json, "write the fit as JSON; - is standard output"),
                       file_option("--html", "FILE", a.html, "write a page: the table, the fit, and what is left"),
                       memory_option(a.max_memory), quiet_option(a.diagnostics)}}},
          .notes = notes,
          .finish = [arguments]() -> Action {
            check_brdf_word("BRDF", arguments->word);
            const BrdfFit one{
                .model = arguments->model,
                .lobes = find_fitted_model(arguments->model)->starts.front()(HighlightShape{}, arguments->lobes, 1)};
            if (arguments->output == standard_output && needs_table(one))
              throw UsageError("--output", "\"-\"", "a name for the material, since a table is written beside it");
            return [arguments] { return run(*arguments); };
          }};
}

} // namespace refraster
