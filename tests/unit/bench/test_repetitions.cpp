#include "bench/measure/repetitions.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace refraster::bench;

namespace {

/// Candidates that note who was drawn, and whose frame number n took n ms.
struct Track {
  std::vector<std::size_t> drawn;
  std::vector<Candidate> candidates;

  explicit Track(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      candidates.push_back([this, i] {
        drawn.push_back(i);
        return FrameTimes{static_cast<double>(drawn.size()), 0, {}, {}};
      });
  }
};

} // namespace

TEST_CASE("in each repetition everybody draws once, and not always in the same order") {
  Track track(5);
  const auto times = interleaved(track.candidates, {.warm_up = 1, .least = 8, .seconds = 0});
  REQUIRE(track.drawn.size() == 9 * 5);
  std::set<std::vector<std::size_t>> orders;
  for (std::size_t repetition = 0; repetition < 9; ++repetition) {
    const auto begin = track.drawn.begin() + static_cast<std::ptrdiff_t>(5 * repetition);
    orders.emplace(begin, begin + 5);
    CHECK(std::set<std::size_t>(begin, begin + 5).size() == 5);
  }
  CHECK(orders.size() > 1);
  REQUIRE(times.size() == 5);
  for (const auto& of_one : times) {
    REQUIRE(of_one.size() == 8); // without the repetition to warm up
    for (std::size_t repetition = 0; repetition < 8; ++repetition) {
      CHECK(of_one[repetition].wall_ms > static_cast<double>(5 * (repetition + 1)));
      CHECK(of_one[repetition].wall_ms <= static_cast<double>(5 * (repetition + 2)));
    }
  }
}

TEST_CASE("a stop ends the repetitions, and the repetition that was begun does not count") {
  std::atomic<bool> stop = false;
  Track track(3);
  track.candidates.push_back([&] {
    if (track.drawn.size() > 10) stop = true;
    return FrameTimes{};
  });
  const auto times = interleaved(track.candidates, {.warm_up = 0, .least = 1000, .seconds = 0, .stop = &stop});
  CHECK(track.drawn.size() < 20);
  for (const auto& of_one : times) CHECK(of_one.size() == times[0].size());
}
