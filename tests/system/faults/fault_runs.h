#pragma once
// Commands of the program under faults, and what they leave on disk. The table of the faults, and the tests, are made
// of these.

#include <string>
#include <vector>

namespace refraster {

/// What was done, how often, and what was left.
struct FaultRow {
  std::string fault;
  int runs = 0;
  int done = 0, refused = 0, killed = 0; // exit code 0 (compare: or 1); 3, 4 or 130; by SIGKILL that we sent
  int old_files = 0, new_files = 0;      // outputs, whole
  int absent = 0;                        // where there was none before
  int left_over = 0;                     // new files, whole, that have kept their temporary name
  double slowest_end_seconds = 0;        // from a signal to the end of the process
  std::vector<std::string> wrong;        // everything that should not be
};

enum class Effort {
  quick,   // three commands, the first calls, the commonest failures
  whole,   // every command and every failure
  thorough // … at every call, and with and without old files
};

/// Every call that a command makes for its outputs fails once, in every way.
std::vector<FaultRow> failing_calls(Effort effort);
/// The process is killed just before each such call.
std::vector<FaultRow> killed_at_calls(Effort effort);
/// … and at random moments.
std::vector<FaultRow> killed_at_random(int runs);
/// Every large allocation fails, alone, or with all that follow.
std::vector<FaultRow> failing_allocations(Effort effort);
/// SIGINT and SIGTERM in the middle of long work.
std::vector<FaultRow> interrupted_runs(Effort effort);

/// As Markdown.
std::string table_of(const std::vector<FaultRow>& rows);

} // namespace refraster
