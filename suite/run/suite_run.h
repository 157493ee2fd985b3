#pragma once
// A suite, run: what is known is taken, what is not is done, and all of it written.

#include "suite/references/update.h"
#include "suite/results/summary.h"
#include "suite/shards/shard.h"
#include "suite/workers/supervisor.h"

#include <functional>
#include <string>
#include <vector>

namespace refraster::suite {

/// Which results of earlier runs of the same folder are taken instead of being found out again.
enum class Reuse {
  none,
  same_inputs, // those that follow from files, settings and program alone, where these are as they were
  resume       // of an interrupted run the others too: what took too long, what was measured
};

/// What a run and an update have in common.
struct SuiteRequest {
  Suite suite;
  std::vector<std::string> only; // names and tags; empty: all entries
  int jobs = 1, threads = 1;     // workers at a time, and threads of each
  std::uint64_t memory_bytes = 0;
  ProcessLimits limits;
  const std::atomic<bool>* stop = nullptr;
  std::function<void(double fraction)> progress = {};
};

/// Those that have one of the words as their name or as a tag; all, without words.
std::vector<Entry> chosen_entries(const std::vector<Entry>& entries, const std::vector<std::string>& only);

struct RunRequest : SuiteRequest {
  std::string results; // folder
  Shard shard;
  Reuse reuse = Reuse::same_inputs;
};

struct RunOutcome {
  Supervised ended = Supervised::all_done;
  RunResults own;   // of this run
  RunResults joint; // with what other shards have in the folder
  std::vector<std::string> notes;
};

/// Runs it. A run that is stopped leaves what it has found out in the folder's journal. Throws InputError for
/// references that cannot be read, OutputError.
RunOutcome run_suite(const RunRequest& request);

struct UpdateOutcome {
  Supervised ended = Supervised::all_done;
  std::vector<UpdatedReference> updated; // stored, if nothing failed
  RunResults failed;                     // entries of which no image could be made: then nothing is stored
};

/// Makes the references of all entries whose action is `compare`. `reason` stands in what changes. Throws InputError,
/// OutputError; then nothing has changed.
UpdateOutcome update_suite(const SuiteRequest& request, const std::string& reason);

} // namespace refraster::suite
