#include "verify/heat_legend.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace refraster;

namespace {

Comparison comparison(double max) {
  Comparison found;
  found.max = max;
  return found;
}

bool has_colour(const Image<std::uint8_t>& image, int first_row, const Rgb8& colour) {
  for (int y = first_row; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (std::equal(colour.begin(), colour.end(), image.at(x, y))) return true;
  return false;
}

} // namespace

TEST_CASE("the legend is below the heat image, which stays as it is") {
  Image<std::uint8_t> heat(500, 3, 3);
  for (std::size_t i = 0; i < heat.values.size(); ++i) heat.values[i] = static_cast<std::uint8_t>(i % 251);
  const Image<std::uint8_t> image = with_legend(heat, comparison(10));
  CHECK(image.width == 500);
  CHECK(image.height > 3);
  CHECK(std::equal(heat.values.begin(), heat.values.end(), image.values.begin()));
}

TEST_CASE("the strip grows with the image, so that its letters can be read") {
  const auto strip_height = [](int width) {
    return with_legend(Image<std::uint8_t>(width, 1, 3), comparison(10)).height - 1;
  };
  CHECK(strip_height(1279) == strip_height(100));
  CHECK(strip_height(1280) == 2 * strip_height(100));
}

TEST_CASE("a narrow image is filled up, pixel by pixel as it is") {
  const Image<std::uint8_t> image = with_legend(Image<std::uint8_t>(2, 2, 3, 77), comparison(1));
  REQUIRE(image.width > 2);
  CHECK(image.at(1, 1)[0] == 77);
  CHECK(image.at(2, 1)[0] != 77);
}

TEST_CASE("the legend has the ends of the ramp, and NaN's colour only where there is one") {
  Comparison found = comparison(100);
  const Image<std::uint8_t> heat(400, 1, 3);
  CHECK(has_colour(with_legend(heat, found), 1, heat_colour(0.5 / 200)));
  CHECK(has_colour(with_legend(heat, found), 1, heat_colour(199.5 / 200)));
  CHECK_FALSE(has_colour(with_legend(heat, found), 1, incomparable_colour));
  found.incomparable_pixels = 1;
  CHECK(has_colour(with_legend(heat, found), 1, incomparable_colour));
}

TEST_CASE("what a colour stands for is the inverse of how a heat image chooses it") {
  for (const CompareUnit unit : {CompareUnit::levels, CompareUnit::values}) {
    Comparison found = comparison(40);
    found.unit = unit;
    const double level = full_range(unit) / 255;
    for (const double d : {0.5, 1.0, 7.0, 40.0}) {
      const double t = std::log1p(d / level) / std::log1p(found.max / level);
      // log1p and expm1 are good to a unit in the last place; the exponent is at most log(40 * 255) = 9.2.
      CHECK(std::abs(difference_at(t, found) - d) <= d * 16 * 0x1p-52);
    }
  }
}
