// refraster brdf plot A [B]

#include "app/brdf/brdf_commands.h"
#include "app/memory_limit.h"
#include "app/options/shared_options.h"
#include "app/output.h"
#include "app/progress_line.h"
#include "app/usage_error.h"
#include "brdf/comparison.h"
#include "brdf/page/page.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

namespace refraster {
namespace {

struct PlotArguments {
  std::string a, b, output, svg_folder;
  MerlLookup lookup = MerlLookup::trilinear;
  Diagnostics diagnostics;
  std::uint64_t max_memory = 0;
};

std::string svg_path(const PlotArguments& arguments, const BrdfChart& chart) {
  return (std::filesystem::path(arguments.svg_folder) / (std::string(chart.name) + ".svg")).string();
}

std::vector<std::string> outputs_of(const PlotArguments& arguments) {
  std::vector<std::string> outputs;
  if (!arguments.output.empty()) outputs.push_back(arguments.output);
  if (!arguments.svg_folder.empty())
    for (const BrdfChart& chart : brdf_charts) outputs.push_back(svg_path(arguments, chart));
  return outputs;
}

std::string page_of(const Brdf& a, const std::optional<Brdf>& b) {
  BrdfPage page{{a, b ? &*b : nullptr}, "brdf plot " + short_label(a), page_facts(a, b ? "a" : "what")};
  if (b) {
    page.title += " beside " + short_label(*b);
    for (auto& row : page_facts(*b, "b")) page.facts.push_back(std::move(row));
    page.comparison = comparison_text({a, *b, {}, compare_brdfs(a, *b)});
  }
  return brdf_page_html(page);
}

ExitCode run(const PlotArguments& arguments) {
  set_memory_limit(arguments.max_memory, 0);
  const std::vector<std::string> outputs = outputs_of(arguments);
  check_different(outputs, {arguments.a, arguments.b});
  if (!arguments.svg_folder.empty()) prepare_folder(arguments.svg_folder);
  for (const std::string& path : outputs) check_writable(path);
  const Brdf a = read_brdf(arguments.a, arguments.lookup, arguments.diagnostics);
  std::optional<Brdf> b;
  if (!arguments.b.empty()) b = read_brdf(arguments.b, arguments.lookup, arguments.diagnostics);
  const auto progress = progress_line(arguments.diagnostics, "plotting");
  if (!arguments.svg_folder.empty())
    for (const BrdfChart& chart : brdf_charts)
      write_text(svg_path(arguments, chart), chart.chart({a, b ? &*b : nullptr}));
  if (!arguments.output.empty()) write_text(arguments.output, page_of(a, b));
  return ExitCode::ok;
}

} // namespace

Command brdf_plot_command() {
  const auto arguments = std::make_shared<PlotArguments>();
  PlotArguments& a = *arguments;
  Option second = brdf_argument("B", a.b, "shown beside it");
  second.occurs = Occurs::at_most_once;
  return {.name = "plot",
          .meaning = "Pictures of a reflectance, or of two beside each other",
          .groups = {{"Reflectances", {brdf_argument("A", a.a, "what to show"), second, lookup_option(a.lookup)}},
                     {"Output",
                      {file_option("-o,--output", "FILE.html", a.output,
                                   "page to write, one file without network; brdf.html if there is no --svg either"),
                       folder_option("--svg", a.svg_folder,
                                     "folder, made if need be, for each picture as a file of its own, as papers need "
                                     "them: slices.svg, profile.svg, lobes.svg, albedo.svg"),
                       memory_option(a.max_memory), quiet_option(a.diagnostics)}}},
          .notes = model_notes(),
          .finish = [arguments]() -> Action {
            check_brdf_word("A", arguments->a);
            if (!arguments->b.empty()) check_brdf_word("B", arguments->b);
            if (arguments->output.empty() && arguments->svg_folder.empty()) arguments->output = "brdf.html";
            if (!arguments->output.empty() && arguments->output != standard_output &&
                std::filesystem::path(arguments->output).extension() != ".html")
              throw UsageError("--output", "\"" + arguments->output + "\"",
                               "a name ending in .html; --svg writes pictures");
            return [arguments] { return run(*arguments); };
          }};
}

} // namespace refraster
