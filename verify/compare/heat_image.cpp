#include "verify/compare/heat_image.h"

#include "verify/compare/compare.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace refraster {
namespace {

constexpr Rgb8 stops[] = {{0x00, 0x00, 0x04}, {0x1b, 0x0c, 0x41}, {0x4a, 0x0c, 0x6b}, {0x78, 0x1c, 0x6d},
                          {0xa5, 0x2c, 0x60}, {0xcf, 0x44, 0x46}, {0xed, 0x69, 0x25}, {0xfb, 0x9b, 0x06},
                          {0xf7, 0xd1, 0x3d}, {0xfc, 0xff, 0xa4}};
constexpr std::size_t steps = std::size(stops) - 1;

// Where anything differs at all, the colour starts here: black is for equal pixels alone.
constexpr double smallest_fraction = 1.0 / static_cast<double>(steps);

} // namespace

Rgb8 heat_colour(double t) {
  const double place = std::clamp(t, 0.0, 1.0) * static_cast<double>(steps);
  const std::size_t stop = std::min(static_cast<std::size_t>(place), steps - 1);
  const double fraction = place - static_cast<double>(stop);
  Rgb8 colour{};
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = static_cast<std::uint8_t>(std::lround(std::lerp(stops[stop][c], stops[stop + 1][c], fraction)));
  return colour;
}

double heat_ramp_end(const Comparison& found, std::optional<double> asked) {
  if (asked) return *asked;
  if (found.max == 0) return 0;
  const int decade = static_cast<int>(std::floor(std::log10(found.max)));
  for (int exponent = decade;; ++exponent)
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double round = digit * std::pow(10.0, exponent);
      if (round >= found.max) return round;
    }
}

Image<std::uint8_t> heat_image(const Image<float>& a, const Image<float>& b, const PixelScale& scale, double ramp_end) {
  const double level = full_range(scale.unit) / 255;
  const double whole = std::log1p(ramp_end / level);
  const Image<double> differences = pixel_differences(a, b, scale);
  Image<std::uint8_t> image(a.width, a.height, 3);
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const double largest = *differences.at(x, y);
      if (largest == 0) continue;
      const Rgb8 colour = std::isfinite(largest)
                              ? heat_colour(std::max(std::log1p(largest / level) / whole, smallest_fraction))
                              : incomparable_colour;
      std::copy(colour.begin(), colour.end(), image.at(x, y));
    }
  }
  return image;
}

} // namespace refraster
