// How far off the area of a needle may be in single precision.

#include "tests/support/random.h"
#include "verify/bounds/area_error.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace refraster::test {
namespace {

constexpr double width = 512, height = 256;

/// A corner that a float holds.
Double2 rounded(double x, double y) {
  return {static_cast<double>(static_cast<float>(x)), static_cast<double>(static_cast<float>(y))};
}

double area_in_double(const std::array<Double2, 3>& c) {
  return (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[1].y - c[0].y) * (c[2].x - c[0].x);
}
/// From the sides that begin at that corner.
float area_in_float(const std::array<Double2, 3>& c, std::size_t first) {
  const auto apart = [&](std::size_t i, int axis) {
    return static_cast<float>(c[(first + i) % 3][axis]) - static_cast<float>(c[first][axis]);
  };
  return apart(1, 0) * apart(2, 1) - apart(1, 1) * apart(2, 0);
}

} // namespace

TEST_CASE("the area of a needle is within its error in single precision, and comes near it") {
  Random random(5);
  double nearest = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double from_x = random.uniform(0, width), from_y = random.uniform(0, height), to_x = random.uniform(0, width),
                 to_y = random.uniform(0, height), thin = std::exp2(-random.uniform(0, 12));
    const std::array<Double2, 3> corners{rounded(from_x, from_y), rounded(to_x, to_y),
                                         rounded(std::min(from_x + thin, width), from_y)};
    const double area = area_in_double(corners);
    if (area == 0) continue;
    const double bound = AreaError(corners, width, height).at(corners[0], 0);
    for (std::size_t first = 0; first < 3; ++first) {
      const double error = std::abs(static_cast<double>(area_in_float(corners, first)) / area - 1);
      constexpr double of_any = 4 * 0x1p-24; // three roundings of a product, and that of the difference
      CHECK(error <= bound + of_any);
      if (bound > 64 * of_any) nearest = std::max(nearest, error / bound);
    }
  }
  CHECK(nearest > 0.25);
  MESSAGE("at most " << nearest << " of the bound");
}

TEST_CASE("where a needle is cut near its tip the piece counts, and only there") {
  const std::array<Double2, 3> corners{Double2(-0.01, 100), Double2(300, 140), Double2(300, 141)};
  const AreaError error(corners, width, height);
  const double whole = AreaError({Double2(0.01, 100), corners[1], corners[2]}, width, height).at({300, 140}, 0);
  CHECK(error.at({100, 113.34}, 0.01) > 100 * whole); // from a tip that is 3 / 100,000 of a pixel wide, along an edge
  CHECK(error.at({100, 113.5}, 0.01) < 2 * whole);
}

TEST_CASE("a triangle along the axes has no error of its own, one without area has any") {
  CHECK(AreaError({Double2(1, 2), Double2(5, 2), Double2(1, 9)}, width, height).at({2, 3}, 0) == 0);
  CHECK(std::isinf(AreaError({Double2(1, 2), Double2(2, 4), Double2(3, 6)}, width, height).at({2, 4}, 0)));
}

} // namespace refraster::test
