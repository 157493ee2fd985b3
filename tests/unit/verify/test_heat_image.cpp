#include "verify/compare/heat_image.h"

#include <doctest/doctest.h>

#include <limits>

using namespace refraster;

namespace {

/// Relative luminance of the sRGB primaries (IEC 61966-2-1), of the stored values: monotonic in what is seen.
double lightness(Rgb8 colour) {
  return 0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2];
}

Rgb8 pixel(const Image<std::uint8_t>& image, int x) {
  const std::uint8_t* at = image.at(x, 0);
  return {at[0], at[1], at[2]};
}

Image<float> row(std::vector<float> values) {
  Image<float> image(static_cast<int>(values.size()), 1, 1);
  image.values = std::move(values);
  return image;
}

Image<std::uint8_t> heat_of(const Image<float>& a, const Image<float>& b, CompareUnit unit,
                            std::optional<double> ramp_end = {}) {
  return heat_image(a, b, unit, heat_ramp_end(compare(a, b, unit, {}), ramp_end));
}

} // namespace

TEST_CASE("a larger difference is never a darker colour") {
  double before = -1;
  for (int i = 0; i <= 1000; ++i) {
    const double now = lightness(heat_colour(i / 1000.0));
    CHECK(now >= before - 1); // each channel is rounded to a level
    before = now;
  }
  CHECK(lightness(heat_colour(0)) < 1);
  CHECK(lightness(heat_colour(1)) > 240);
}

TEST_CASE("equal is black, the largest difference is the end of the ramp, the smallest is seen") {
  const auto a = row({0, 0, 0}), b = row({0, 1e-12F, 1});
  const Image<std::uint8_t> heat = heat_of(a, b, CompareUnit::values);
  CHECK(pixel(heat, 0) == Rgb8{0, 0, 0});
  CHECK(lightness(pixel(heat, 1)) > 10);
  CHECK(pixel(heat, 2) == heat_colour(1));
}

TEST_CASE("NaN has a colour of its own") {
  const auto a = row({std::numeric_limits<float>::quiet_NaN(), 0}), b = row({0, 0});
  CHECK(pixel(heat_of(a, b, CompareUnit::values), 0) == incomparable_colour);
}

TEST_CASE("the ramp is logarithmic: with seven levels at its end, one level is at a third") {
  const auto a = row({0, 0}), b = row({1, 7});
  CHECK(pixel(heat_of(a, b, CompareUnit::levels, 7), 0) == heat_colour(1.0 / 3)); // log 2 / log 8
}

TEST_CASE("the ramp ends at a round number that is not below the largest difference, or where it is asked to") {
  const auto end = [](double max) {
    Comparison found;
    found.max = max;
    return heat_ramp_end(found);
  };
  for (const auto& [max, round] : {std::pair(0.0, 0.0), std::pair(1.0, 1.0), std::pair(1.01, 2.0), std::pair(3.0, 5.0),
                                   std::pair(5.0, 5.0), std::pair(74.0, 100.0), std::pair(255.0, 500.0),
                                   std::pair(0.0003, 0.0005), std::pair(1e30, 1e30), std::pair(1e-12, 1e-12)})
    CHECK(end(max) == doctest::Approx(round).epsilon(1e-12));
  for (double max = 1e-9; max < 1e9; max *= 1.37) {
    CHECK(end(max) >= max);
    CHECK(end(max) < 2.5 * max * (1 + 1e-12)); // 2 is the next after 1, 5 after 2
  }
}

TEST_CASE(
    "two heat images with one end have the same colours for the same differences, and what is beyond has its colour") {
  const auto zero = row({0, 0, 0});
  const auto small = heat_of(zero, row({3, 1, 0}), CompareUnit::levels, 10);
  const auto large = heat_of(zero, row({3, 10, 200}), CompareUnit::levels, 10);
  CHECK(pixel(small, 0) == pixel(large, 0));
  CHECK(pixel(large, 1) == heat_colour(1));
  CHECK(pixel(large, 2) == heat_colour(1));
}
