#include "bench/measure/rounds.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace refraster::bench;

namespace {

/// Contenders that note who was drawn, and whose frame number n took n ms.
struct Track {
  std::vector<std::size_t> drawn;
  std::vector<Contender> contenders;

  explicit Track(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      contenders.push_back([this, i] {
        drawn.push_back(i);
        return FrameTimes{static_cast<double>(drawn.size()), 0, {}, {}};
      });
  }
};

} // namespace

TEST_CASE("in each round everybody draws once, and not always in the same order") {
  Track track(5);
  const auto times = interleaved(track.contenders, {.warm_up = 1, .least = 8, .seconds = 0});
  REQUIRE(track.drawn.size() == 9 * 5);
  std::set<std::vector<std::size_t>> orders;
  for (std::size_t round = 0; round < 9; ++round) {
    const auto begin = track.drawn.begin() + static_cast<std::ptrdiff_t>(5 * round);
    orders.emplace(begin, begin + 5);
    CHECK(std::set<std::size_t>(begin, begin + 5).size() == 5);
  }
  CHECK(orders.size() > 1);
  REQUIRE(times.size() == 5);
  for (const auto& of_one : times) {
    REQUIRE(of_one.size() == 8); // without the round to warm up
    for (std::size_t round = 0; round < 8; ++round) {
      CHECK(of_one[round].wall_ms > static_cast<double>(5 * (round + 1)));
      CHECK(of_one[round].wall_ms <= static_cast<double>(5 * (round + 2)));
    }
  }
}

TEST_CASE("a stop ends the rounds, and the round that was begun does not count") {
  std::atomic<bool> stop = false;
  Track track(3);
  track.contenders.push_back([&] {
    if (track.drawn.size() > 10) stop = true;
    return FrameTimes{};
  });
  const auto times = interleaved(track.contenders, {.warm_up = 0, .least = 1000, .seconds = 0, .stop = &stop});
  CHECK(track.drawn.size() < 20);
  for (const auto& of_one : times) CHECK(of_one.size() == times[0].size());
}
