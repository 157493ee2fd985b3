#pragma once
// Processor time of a team of threads, less what they spend looking out for one another.

#include "raster/stopwatch.h"

#include <atomic>

namespace refraster {

/// While it lives, adds up the time on processors that this thread spends and what others spend in the bodies of loops
/// that this thread gives to parallel_for(). Threads that are done with a loop look out for the next one at full speed,
/// for up to some milliseconds (GOMP_SPINCOUNT): that is no work, and is not counted. One at a time counts in a thread:
/// the newest.
class ProcessorTime {
public:
  ProcessorTime();
  ~ProcessorTime();
  ProcessorTime(const ProcessorTime&) = delete;
  ProcessorTime& operator=(const ProcessorTime&) = delete;

  /// So far. To be called by the thread that made it.
  double milliseconds() const { return own_.milliseconds() + 1e-6 * static_cast<double>(others_ns_ - waited_ns_); }

  /// That of the calling thread, or null.
  static ProcessorTime* current();
  /// For parallel_for(): seconds that another thread spent, and that this one spent waiting for others.
  void add_other(double seconds) { others_ns_ += nanoseconds(seconds); }
  void add_waiting(double seconds) { waited_ns_ += nanoseconds(seconds); }

private:
  static long long nanoseconds(double seconds) { return static_cast<long long>(1e9 * seconds); }

  ProcessorTime* before_;
  std::atomic<long long> others_ns_{0};
  long long waited_ns_ = 0;
  Stopwatch own_{TimeOf::thread};
};

} // namespace refraster
