// refraster suite update SUITE.json | SCENE…

#include "app/output.h"
#include "app/progress_line.h"
#include "app/suite/suite_commands.h"
#include "app/usage_error.h"
#include "io/file/text.h"

#include <iostream>
#include <memory>

namespace refraster {
namespace {

struct SuiteUpdateArguments : SuiteArguments {
  std::string reason;
};

ExitCode run(const SuiteUpdateArguments& a) {
  suite::SuiteRequest request;
  fill_request(request, a);
  const std::string folder = request.suite.references;
  if (folder.empty()) throw UsageError("--references", "nothing", "the folder of references");
  auto line = progress_line(a.diagnostics, "making " + counted(request.suite.entries.size(), "reference"));
  if (line) request.progress = [&line](double fraction) { line->show(fraction); };
  const suite::UpdateOutcome outcome = suite::update_suite(request, a.reason);
  line.reset(); // before anything is printed
  if (outcome.ended == suite::Supervised::stopped) return ExitCode::interrupted;
  for (const suite::EntryResult& failed : outcome.failed.entries)
    std::cerr << "refraster: " << failed.name << ": " << failed.message << "\n";
  if (!outcome.failed.entries.empty()) {
    std::cerr << "refraster: no reference is stored\n";
    return static_cast<ExitCode>(outcome.failed.exit_code());
  }
  if (a.diagnostics.verbosity == Verbosity::normal) std::cout << suite::update_text(outcome.updated, folder);
  return ExitCode::ok;
}

} // namespace

Command suite_update_command() {
  const auto arguments = std::make_shared<SuiteUpdateArguments>();
  SuiteUpdateArguments& a = *arguments;
  return {.name = "update",
          .meaning = "Make what entries show now their references",
          .groups = {suite_options(a),
                     entry_options(a),
                     {"References",
                      {word_option(
                           "--reference", {"image", "digest"},
                           [&a](std::size_t i) {
                             a.common.reference = EnumNames<suite::ReferenceKind>::names[i].first;
                             a.given.emplace_back("--reference");
                           },
                           "what is stored of a scene: its image, or the sha256 of its floats"),
                       text_option("--reason", "TEXT", a.reason, "why: recorded with each reference that changes")}},
                     {"Run", work_options(a)}},
          .notes = {"All references change at one moment, or none does: if an entry cannot be made, nothing is stored. "
                    "Each record says by which version, in which precision and why. docs/suite.md"},
          .finish = [arguments]() -> Action {
            if (arguments->files.empty()) throw UsageError("suite update", "nothing", "a suite file or scenes");
            return [arguments] { return run(*arguments); };
          }};
}

} // namespace refraster
