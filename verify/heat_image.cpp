#include "verify/heat_image.h"

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
constexpr double smallest_share = 1.0 / static_cast<double>(steps);

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

Image<std::uint8_t> heat_image(const Image<float>& a, const Image<float>& b, const Comparison& found) {
  const double level = full_range(found.unit) / 255;
  const double whole = std::log1p(found.max / level);
  const Image<double> differences = pixel_differences(a, b);
  Image<std::uint8_t> image(a.width, a.height, 3);
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const double largest = *differences.at(x, y);
      if (largest == 0) continue;
      const bool comparable = largest <= found.max;
      const Rgb8 colour =
          comparable ? heat_colour(std::max(std::log1p(largest / level) / whole, smallest_share)) : incomparable_colour;
      std::copy(colour.begin(), colour.end(), image.at(x, y));
    }
  }
  return image;
}

} // namespace refraster
