#include "raster/samples.h"

#include <cassert>

namespace refraster {

namespace {

template <std::size_t N>
constexpr std::array<SamplePosition, N> sixteenths(const std::array<SamplePosition, N>& places) {
  std::array<SamplePosition, N> result{};
  for (std::size_t i = 0; i < N; ++i) result[i] = {places[i].x * 16, places[i].y * 16};
  return result;
}

constexpr auto one = sixteenths<1>({{{8, 8}}});
constexpr auto two = sixteenths<2>({{{12, 12}, {4, 4}}});
constexpr auto four = sixteenths<4>({{{6, 2}, {14, 6}, {2, 10}, {10, 14}}});
constexpr auto eight = sixteenths<8>({{{9, 5}, {7, 11}, {13, 9}, {5, 3}, {3, 13}, {1, 7}, {11, 15}, {15, 1}}});
constexpr auto sixteen = sixteenths<16>({{{9, 9},
                                          {7, 5},
                                          {5, 10},
                                          {12, 7},
                                          {3, 6},
                                          {10, 13},
                                          {13, 11},
                                          {11, 3},
                                          {6, 14},
                                          {8, 1},
                                          {4, 2},
                                          {2, 12},
                                          {0, 8},
                                          {15, 4},
                                          {14, 15},
                                          {1, 0}}});

} // namespace

std::span<const SamplePosition> sample_pattern(int samples) {
  assert(is_sample_count(samples));
  switch (samples) {
  case 2:
    return two;
  case 4:
    return four;
  case 8:
    return eight;
  case 16:
    return sixteen;
  default:
    return one;
  }
}

bool is_sample_count(int samples) {
  return samples == 1 || samples == 2 || samples == 4 || samples == 8 || samples == 16;
}

} // namespace refraster
