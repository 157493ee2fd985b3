#include "bench/machine/clocks.h"

#include <ctime>

#if defined(__x86_64__)
#include <x86intrin.h>
#endif

namespace refraster::bench {
namespace {

double milliseconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

} // namespace

double wall_ms() {
  return milliseconds(CLOCK_MONOTONIC);
}

double process_cpu_ms() {
  return milliseconds(CLOCK_PROCESS_CPUTIME_ID);
}

double time_stamp_ghz() {
#if defined(__x86_64__)
  const double start_ms = milliseconds(CLOCK_MONOTONIC_RAW);
  const auto start = __rdtsc();
  double now_ms = start_ms;
  while (now_ms - start_ms < 20) now_ms = milliseconds(CLOCK_MONOTONIC_RAW); // reads take 50 ns: 4 digits and more
  return static_cast<double>(__rdtsc() - start) / (now_ms - start_ms) * 1e-6;
#else
  return 0;
#endif
}

} // namespace refraster::bench
