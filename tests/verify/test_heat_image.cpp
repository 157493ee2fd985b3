#include "verify/heat_image.h"

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
  const Image<std::uint8_t> heat = heat_image(a, b, compare(a, b, CompareUnit::values, {}));
  CHECK(pixel(heat, 0) == Rgb8{0, 0, 0});
  CHECK(lightness(pixel(heat, 1)) > 10);
  CHECK(pixel(heat, 2) == heat_colour(1));
}

TEST_CASE("NaN has a colour of its own") {
  const auto a = row({std::numeric_limits<float>::quiet_NaN(), 0}), b = row({0, 0});
  CHECK(pixel(heat_image(a, b, compare(a, b, CompareUnit::values, {})), 0) == incomparable_colour);
}

TEST_CASE("the ramp is logarithmic: with seven levels at its end, one level is at a third") {
  const auto a = row({0, 0}), b = row({1, 7});
  CHECK(pixel(heat_image(a, b, compare(a, b, CompareUnit::levels, {})), 0) == heat_colour(1.0 / 3)); // log 2 / log 8
}
