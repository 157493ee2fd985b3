// refraster suite run SUITE.json | SCENE…

#include "app/options/shared_options.h"
#include "app/output.h"
#include "app/progress_line.h"
#include "app/suite/suite_commands.h"
#include "app/usage_error.h"

#include <iostream>
#include <memory>

namespace refraster {
namespace {

struct SuiteRunArguments : SuiteArguments {
  std::string results = "results", markdown;
  Shard shard;
  suite::Reuse reuse = suite::Reuse::same_inputs;
};

ExitCode run(const SuiteRunArguments& a) {
  check_different({a.markdown}, a.files);
  if (!a.markdown.empty()) check_writable(a.markdown);
  suite::RunRequest request;
  fill_request(request, a);
  request.results = a.results;
  request.shard = a.shard;
  request.reuse = a.reuse;
  auto line = progress_line(a.diagnostics, "running the suite");
  if (line) request.progress = [&line](double fraction) { line->show(fraction); };
  const suite::RunOutcome outcome = suite::run_suite(request);
  line.reset(); // before anything is printed
  for (const std::string& note : outcome.notes) print_note(note, a.diagnostics);
  if (outcome.ended == suite::Supervised::stopped) {
    print_note("what is done is in " + a.results + "; --resume goes on", a.diagnostics);
    return ExitCode::interrupted;
  }
  if (!a.markdown.empty()) write_text(a.markdown, suite::summary_markdown(outcome.own));
  if (a.diagnostics.verbosity == Verbosity::normal && a.markdown != standard_output)
    std::cout << suite::summary_text(outcome.own, a.results);
  return static_cast<ExitCode>(outcome.own.exit_code());
}

} // namespace

Command suite_run_command() {
  const auto arguments = std::make_shared<SuiteRunArguments>();
  SuiteRunArguments& a = *arguments;
  return {
      .name = "run",
      .meaning = "Make every entry, and hold it against its reference",
      .groups = {suite_options(a),
                 entry_options(a),
                 {"Results",
                  {folder_option("-o,--output", a.results,
                                 "folder of results, made if need be: index.html, results.json, junit.xml, images")
                       .by_default("results"),
                   file_option("--markdown", "FILE", a.markdown, "write a summary as Markdown; - is standard output")}},
                 {"Run",
                  joined({{shard_option(a.shard, "do part I of N: the same parts on every machine"),
                           flag(
                               "--no-cache", [&a] { a.reuse = suite::Reuse::none; },
                               "do every entry, also where nothing has changed since its last result"),
                           flag(
                               "--resume", [&a] { a.reuse = suite::Reuse::resume; },
                               "go on with an interrupted run: what it has done is not done again, failures included")},
                          work_options(a)})}},
      .notes =
          {"An entry whose files, options, program and driver are those of its last result in the folder of "
           "results is not done again. docs/suite.md",
           "Exit code: 0 all equal or explained, 1 differences, 3 entries that cannot be read or that exceed their "
           "time or memory, 4 cannot write, 5 no OpenGL, 130 interrupted."},
      .finish = [arguments]() -> Action {
        if (arguments->files.empty()) throw UsageError("suite run", "nothing", "a suite file or scenes");
        return [arguments] { return run(*arguments); };
      }};
}

} // namespace refraster
