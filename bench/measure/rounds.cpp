#include "bench/measure/rounds.h"

#include "bench/machine/clocks.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace refraster::bench {

std::vector<std::vector<FrameTimes>> interleaved(std::span<const Contender> contenders, const Rounds& rounds) {
  std::vector<std::vector<FrameTimes>> times(contenders.size());
  std::vector<FrameTimes> round(contenders.size());
  std::vector<std::size_t> order(contenders.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937 random; // the same order in every run
  const auto draw_all = [&] {
    std::shuffle(order.begin(), order.end(), random);
    for (const std::size_t i : order) {
      if (rounds.stop && rounds.stop->load()) return;
      round[i] = contenders[i]();
    }
  };
  for (int i = 0; i < rounds.warm_up; ++i) draw_all();
  const double start = wall_ms(), budget = rounds.seconds * 1e3;
  for (int done = 0;; ++done) {
    const double spent = wall_ms() - start;
    // The next round is taken to last as long as the mean of those before.
    if (done >= rounds.least && (done == 0 || spent * (done + 1) / done > budget)) break;
    if (rounds.progress)
      rounds.progress(std::min(static_cast<double>(done) / rounds.least, budget > 0 ? spent / budget : 1));
    draw_all();
    if (rounds.stop && rounds.stop->load()) break;
    for (std::size_t i = 0; i < contenders.size(); ++i) times[i].push_back(round[i]);
  }
  return times;
}

} // namespace refraster::bench
