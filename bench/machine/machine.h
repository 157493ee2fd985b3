#pragma once
// What a figure was measured on, and when.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace refraster::bench {

/// Empty or 0: the machine does not say.
struct Machine {
  std::string cpu;                 // model, in the maker's words
  int cpus = 0;                    // online
  std::vector<int> usable_cpus;    // by this process
  std::vector<std::string> caches; // "L1 data 32K", …: of one core
  std::string virtualized;         // "yes" in a virtual machine, where neighbours are not seen
  std::uint64_t memory_bytes = 0;
  std::string kernel;   // "Linux 6.1.0"
  std::string governor; // of the clock
  double time_stamp_ghz = 0;
};
Machine this_machine();

/// Means over 1, 5 and 15 minutes of how many threads wanted to run.
std::array<double, 3> load_average();

/// "2025-01-31T12:00:00Z".
std::string utc_now();

/// How this program was compiled: its flags, and the revision of its source, "" outside a repository. The latter is
/// that of the last run of cmake.
struct Origin {
  std::string flags, revision;
};
Origin this_origin();

} // namespace refraster::bench
