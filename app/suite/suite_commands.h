#pragma once
// The commands of `refraster suite`, a file each, and what they have in common.

#include "app/command.h"
#include "app/diagnostics.h"
#include "app/options/picture_options.h"
#include "suite/run/suite_run.h"

#include <optional>
#include <string>
#include <vector>

namespace refraster {

Command suite_run_command();    // run_command.cpp
Command suite_update_command(); // update_command.cpp
Command suite_merge_command();  // merge_command.cpp

/// What of a suite the command line says.
struct SuiteArguments {
  std::vector<std::string> files; // a suite file, or scenes
  std::string references;
  std::vector<std::string> only;
  int jobs = 0; // 0: as many as there are processors
  std::uint64_t max_memory = 0;
  Diagnostics diagnostics;
  // Of scenes: what a suite file says otherwise.
  PictureArguments picture;
  suite::Entry common;
  std::vector<std::string> given; // names of those options that are there
};

/// SCENE…, --references, --only.
OptionGroup suite_options(SuiteArguments& arguments);
/// --size, --samples, --precision and what else an entry of a suite file says.
OptionGroup entry_options(SuiteArguments& arguments);
/// --jobs, --max-memory, --quiet.
std::vector<Option> work_options(SuiteArguments& arguments);

/// The suite file, or the scenes as one; throws InputError, UsageError for a word of --only that is none.
suite::Suite suite_of(const SuiteArguments& arguments);

/// What both commands ask for.
void fill_request(suite::SuiteRequest& request, const SuiteArguments& arguments);

} // namespace refraster
