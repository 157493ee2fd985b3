#include "bench/machine/clocks.h"

#include "raster/stopwatch.h"

#if defined(__x86_64__)
#include <x86intrin.h>
#endif

namespace refraster::bench {

double time_stamp_ghz() {
#if defined(__x86_64__)
  const Stopwatch stopwatch;
  const auto start = __rdtsc();
  double ms = 0;
  while (ms < 20) ms = stopwatch.milliseconds(); // a read takes 50 ns, and a clock that is being set may be 500 ppm off
  return static_cast<double>(__rdtsc() - start) / ms * 1e-6;
#else
  return 0;
#endif
}

} // namespace refraster::bench
