#pragma once
// How long something takes.

#include <ctime>
#include <utility>

namespace refraster {

/// Wall time; or time on a processor, of all threads of this process or of the one that asks.
enum class TimeOf { wall, process, thread };

/// Measures from when it is made.
class Stopwatch {
public:
  explicit Stopwatch(TimeOf of = TimeOf::wall)
      : clock_(of == TimeOf::wall      ? CLOCK_MONOTONIC
               : of == TimeOf::process ? CLOCK_PROCESS_CPUTIME_ID
                                       : CLOCK_THREAD_CPUTIME_ID),
        start_(now()) {}

  double seconds() const { return between(start_, now()); }
  double milliseconds() const { return 1e3 * seconds(); }
  /// The seconds so far; starts again.
  double lap() {
    const timespec before = std::exchange(start_, now());
    return between(before, start_);
  }

private:
  timespec now() const {
    timespec time{};
    clock_gettime(clock_, &time);
    return time;
  }
  static double between(const timespec& start, const timespec& end) {
    return static_cast<double>(end.tv_sec - start.tv_sec) + 1e-9 * static_cast<double>(end.tv_nsec - start.tv_nsec);
  }

  clockid_t clock_;
  timespec start_;
};

} // namespace refraster
