// refraster brdf info BRDF

#include "app/brdf/brdf_commands.h"
#include "app/memory_limit.h"
#include "app/options/shared_options.h"
#include "app/output.h"
#include "app/progress_line.h"
#include "brdf/facts.h"

#include <iostream>
#include <memory>

namespace refraster {
namespace {

struct InfoArguments {
  std::string word, json;
  MerlLookup lookup = MerlLookup::trilinear;
  Diagnostics diagnostics;
  std::uint64_t max_memory = 0;
};

ExitCode run(const InfoArguments& arguments) {
  set_memory_limit(arguments.max_memory, 0);
  check_different({arguments.json}, {arguments.word});
  if (!arguments.json.empty()) check_writable(arguments.json);
  const Brdf brdf = read_brdf(arguments.word, arguments.lookup, arguments.diagnostics);
  auto progress = progress_line(arguments.diagnostics, "looking into " + arguments.word);
  const BrdfInfo info = brdf_info(brdf);
  progress.reset();
  for (const std::string& sentence : impossibilities(info.facts))
    print_note(arguments.word + ": " + sentence, arguments.diagnostics);
  if (!arguments.json.empty()) write_text(arguments.json, info_json(info));
  if (arguments.json != standard_output) std::cout << info_text(info);
  return ExitCode::ok;
}

} // namespace

Command brdf_info_command() {
  const auto arguments = std::make_shared<InfoArguments>();
  InfoArguments& a = *arguments;
  return {.name = "info",
          .meaning = "What is in a table, or what a model reflects",
          .groups = {{"Reflectance", {brdf_argument("BRDF", a.word, "what to look into"), lookup_option(a.lookup)}},
                     {"Report",
                      {file_option("--json", "FILE", a.json, "write the facts as JSON; - is standard output"),
                       memory_option(a.max_memory), quiet_option(a.diagnostics)}}},
          .notes = model_notes(),
          .finish = [arguments]() -> Action {
            check_brdf_word("BRDF", arguments->word);
            return [arguments] { return run(*arguments); };
          }};
}

} // namespace refraster
