#include "bench/measure/repetitions.h"

#include "raster/stopwatch.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace refraster::bench {

std::vector<std::vector<FrameTimes>> interleaved(std::span<const Candidate> candidates,
                                                 const Repetitions& repetitions) {
  std::vector<std::vector<FrameTimes>> times(candidates.size());
  std::vector<FrameTimes> repetition(candidates.size());
  std::vector<std::size_t> order(candidates.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937 random; // the same order in every run
  const auto draw_all = [&] {
    std::shuffle(order.begin(), order.end(), random);
    for (const std::size_t i : order) {
      if (repetitions.stop && repetitions.stop->load()) return;
      repetition[i] = candidates[i]();
    }
  };
  for (int i = 0; i < repetitions.warm_up; ++i) draw_all();
  const Stopwatch stopwatch;
  for (int done = 0;; ++done) {
    const double spent = stopwatch.seconds();
    // The next repetition is taken to last as long as the mean of those before.
    if (done >= repetitions.least && (done == 0 || spent * (done + 1) / done > repetitions.seconds)) break;
    if (repetitions.progress)
      repetitions.progress(std::min(static_cast<double>(done) / repetitions.least,
                                    repetitions.seconds > 0 ? spent / repetitions.seconds : 1));
    draw_all();
    if (repetitions.stop && repetitions.stop->load()) break;
    for (std::size_t i = 0; i < candidates.size(); ++i) times[i].push_back(repetition[i]);
  }
  return times;
}

} // namespace refraster::bench
