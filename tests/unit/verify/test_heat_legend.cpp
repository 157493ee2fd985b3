#include "verify/compare/heat_legend.h"

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
  const Image<std::uint8_t> image = with_legend(heat, comparison(10), 10);
  CHECK(image.width == 500);
  CHECK(image.height > 3);
  CHECK(std::equal(heat.values.begin(), heat.values.end(), image.values.begin()));
}

TEST_CASE("the strip grows with the image, so that its letters can be read") {
  const auto strip_height = [](int width) {
    return with_legend(Image<std::uint8_t>(width, 1, 3), comparison(10), 10).height - 1;
  };
  CHECK(strip_height(1279) == strip_height(100));
  CHECK(strip_height(1280) == 2 * strip_height(100));
}

TEST_CASE("a narrow image is filled up, pixel by pixel as it is") {
  const Image<std::uint8_t> image = with_legend(Image<std::uint8_t>(2, 2, 3, 77), comparison(1), 1);
  REQUIRE(image.width > 2);
  CHECK(image.at(1, 1)[0] == 77);
  CHECK(image.at(2, 1)[0] != 77);
}

TEST_CASE("the legend has the ends of the ramp, and NaN's colour only where there is one") {
  Comparison found = comparison(100);
  const Image<std::uint8_t> heat(400, 1, 3);
  CHECK(has_colour(with_legend(heat, found, 100), 1, heat_colour(0.5 / 200)));
  CHECK(has_colour(with_legend(heat, found, 100), 1, heat_colour(199.5 / 200)));
  CHECK_FALSE(has_colour(with_legend(heat, found, 100), 1, incomparable_colour));
  found.incomparable_pixels = 1;
  CHECK(has_colour(with_legend(heat, found, 100), 1, incomparable_colour));
}

TEST_CASE("labels of the ramp are round numbers from 0 to its end, each with room for itself") {
  using Ticks = std::vector<double>;
  // log 1.5 / log 101 of 199 points is 17.5: "0.5" with a space of a letter would reach to 33.5, and 1 stands at 29.9.
  CHECK(legend_ticks(100, CompareUnit::levels) == Ticks{0, 1, 2, 5, 10, 20, 50, 100});
  CHECK(legend_ticks(10, CompareUnit::levels).back() == 10);
  for (const CompareUnit unit : {CompareUnit::levels, CompareUnit::values})
    for (double end = 1e-6; end < 1e6; end *= 10)
      for (const double digit : {1.0, 2.0, 5.0}) {
        CAPTURE(digit * end);
        const Ticks ticks = legend_ticks(digit * end, unit);
        CHECK(ticks.size() >= 2);
        CHECK(ticks.front() == 0);
        CHECK(ticks.back() == digit * end);
        for (std::size_t i = 1; i < ticks.size(); ++i) {
          // A letter is 4 points wide, the ramp 200: two labels of one letter are at least 8 points apart.
          CHECK(ramp_position(ticks[i], digit * end, unit) - ramp_position(ticks[i - 1], digit * end, unit) >=
                5.0 / 200);
          const double decade = std::pow(10.0, std::floor(std::log10(ticks[i]) + 1e-9));
          const double first_digit = ticks[i] / decade;
          CHECK((std::abs(first_digit - 1) < 1e-9 || std::abs(first_digit - 2) < 1e-9 ||
                 std::abs(first_digit - 5) < 1e-9));
        }
      }
}

TEST_CASE("a label stands where a heat image has its colour") {
  for (const CompareUnit unit : {CompareUnit::levels, CompareUnit::values}) {
    Image<float> zero(3, 1, 1), other(3, 1, 1);
    const auto scale = static_cast<float>(full_range(unit) / 255);
    other.values = {0.5f * scale, 7 * scale, 40 * scale};
    const double end = 50 * full_range(unit) / 255;
    const Image<std::uint8_t> heat = heat_image(zero, other, unit, end);
    for (int x = 0; x < 3; ++x) {
      const double difference = static_cast<double>(other.values[static_cast<std::size_t>(x)]);
      const Rgb8 colour = heat_colour(std::max(ramp_position(difference, end, unit), 1.0 / 9));
      CHECK(std::equal(colour.begin(), colour.end(), heat.at(x, 0)));
    }
  }
}
