#include "bench/measure/statistics.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace refraster::bench;

TEST_CASE("quartiles cut the sorted values into quarters") {
  const Spread five = spread_of({5, 1, 4, 2, 3});
  CHECK(five.min == 1);
  CHECK(five.lower == 2);
  CHECK(five.median == 3);
  CHECK(five.upper == 4);
  CHECK(five.max == 5);
  const Spread two = spread_of({10, 20});
  CHECK(two.lower == 12.5);
  CHECK(two.median == 15);
  CHECK(two.upper == 17.5);
  const Spread one = spread_of({7});
  CHECK(one.min == 7);
  CHECK(one.lower == 7);
  CHECK(one.max == 7);
}

TEST_CASE("the middle half leaves out as many small values as large ones") {
  const std::vector<double> values = {9, 1, 5, 100, 4, 6, 0, 7};
  std::vector<double> kept;
  for (const std::size_t i : middle_half(values)) kept.push_back(values[i]);
  std::sort(kept.begin(), kept.end());
  CHECK(kept == std::vector<double>{4, 5, 6, 7});
  CHECK(middle_half(std::vector<double>{3, 2, 1}).size() == 3); // too few to leave any out
}

TEST_CASE("the slope of a power is its exponent, without error") {
  std::vector<Point> points;
  for (const double x : {1.0, 3.0, 10.0, 1000.0}) points.push_back({x, 7 * std::pow(x, 1.5)});
  const Slope slope = log_log_slope(points);
  CHECK(slope.value == doctest::Approx(1.5).epsilon(1e-12));
  CHECK(slope.error == doctest::Approx(0).epsilon(1e-12));
}

TEST_CASE("the standard error of a slope is that of least squares") {
  // In natural logarithms (0, 0), (1, 1), (2, 3): slope 1.5; residuals 1/6, -1/3, 1/6; sqrt((1/6) / 1 / 2).
  const std::vector<Point> points = {{1, 1}, {std::exp(1), std::exp(1)}, {std::exp(2), std::exp(3)}};
  const Slope slope = log_log_slope(points);
  CHECK(slope.value == doctest::Approx(1.5));
  CHECK(slope.error == doctest::Approx(std::sqrt(1.0 / 12)));
}
