#pragma once
// A process that does entries, one after the other.

#include "suite/actions/workplace.h"
#include "suite/workers/channel.h"

#include "raster/stopwatch.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace refraster::suite {

/// What the program around knows how to do to a process (app/memory_limit.h).
struct ProcessLimits {
  std::function<MemoryBudget(std::uint64_t bytes, int threads)> set_memory;
  std::function<void()> clear_memory; // for drivers, which do not bear it
};

/// How a worker ended.
struct Ending {
  int signal = 0, exit_code = 0;
};

/// A child process that is forked, not started anew: it knows the entries. Its parent must not have used OpenMP, whose
/// threads no child inherits. It ends with its parent, whatever that one ends by.
class Worker {
public:
  /// Throws std::runtime_error if there can be no further process. memory_bytes: what it may take; 0: as much as there
  /// is.
  Worker(const std::vector<Entry>& entries, const Workplace& workplace, const ProcessLimits& limits,
         std::uint64_t memory_bytes);
  /// Ends it.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  int socket() const { return socket_; }
  pid_t process() const { return process_; }
  bool is_idle() const { return !entry_; }
  /// At what it is.
  std::size_t entry() const { return *entry_; }
  double seconds() const { return since_.seconds(); }
  /// Resident at this moment.
  std::uint64_t memory_bytes() const;

  /// Of a profile that its driver was chosen by, which cannot be undone; nothing as long as it has used none.
  const std::optional<std::string>& device() const { return device_; }

  /// False if it is not there any more.
  bool begin(std::size_t entry, const Entry& what);
  /// What it says, if all of it has come; `closed` is set where nothing will come any more.
  std::optional<std::string> result(bool& closed);
  /// Waits for its end, at once if it is told to.
  enum class How { by_itself, at_once };
  Ending end(How how);

private:
  pid_t process_ = -1;
  int socket_ = -1;
  std::optional<std::size_t> entry_;
  std::optional<std::string> device_;
  Stopwatch since_;
  MessageReader reader_;
};

/// What `make` gives, made by a child process of its own, so that what it leaves in a process, drivers and threads,
/// ends with it. Empty if it fails.
std::string made_by_child(const std::function<std::string()>& make);

} // namespace refraster::suite
