// refraster suite merge DIR…

#include "app/options/shared_options.h"
#include "app/output.h"
#include "app/suite/suite_commands.h"
#include "app/usage_error.h"
#include "suite/shards/merge.h"

#include <iostream>
#include <memory>

namespace refraster {
namespace {

struct SuiteMergeArguments {
  std::vector<std::string> folders;
  std::string results = "results", markdown;
  Diagnostics diagnostics;
};

ExitCode run(const SuiteMergeArguments& a) {
  if (!a.markdown.empty()) check_writable(a.markdown);
  const suite::Merged merged = suite::merge_results(a.folders, a.results);
  for (const std::string& note : merged.notes) print_note(note, a.diagnostics);
  if (!a.markdown.empty()) write_text(a.markdown, suite::summary_markdown(merged.results));
  if (a.diagnostics.verbosity == Verbosity::normal && a.markdown != standard_output)
    std::cout << suite::summary_text(merged.results, a.results);
  return static_cast<ExitCode>(merged.results.exit_code());
}

} // namespace

Command suite_merge_command() {
  const auto arguments = std::make_shared<SuiteMergeArguments>();
  SuiteMergeArguments& a = *arguments;
  return {.name = "merge",
          .meaning = "Join the results of shards",
          .groups =
              {{"Results",
                {refraster::arguments("DIR", a.folders, "folders of results"),
                 folder_option("-o,--output", a.results, "folder of the whole, made if need be").by_default("results"),
                 file_option("--markdown", "FILE", a.markdown, "write a summary as Markdown; - is standard output"),
                 quiet_option(a.diagnostics)}}},
          .notes = {"Says what no shard has done, and where two contradict each other: then the exit code is 1. "
                    "docs/suite.md"},
          .finish = [arguments]() -> Action {
            if (arguments->folders.empty()) throw UsageError("suite merge", "nothing", "folders of results");
            return [arguments] { return run(*arguments); };
          }};
}

} // namespace refraster
