#include "brdf/page/colour_map.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace refraster {
namespace {

using Stop = std::array<std::uint8_t, 3>;

// Every eighth of each map.
constexpr Stop viridis[] = {{0x44, 0x01, 0x54}, {0x47, 0x2d, 0x7b}, {0x3b, 0x52, 0x8b},
                            {0x2c, 0x72, 0x8e}, {0x21, 0x91, 0x8c}, {0x28, 0xae, 0x80},
                            {0x5e, 0xc9, 0x62}, {0xad, 0xdc, 0x30}, {0xfd, 0xe7, 0x25}};
constexpr Stop blue_to_red[] = {{0x21, 0x66, 0xac}, {0x43, 0x93, 0xc3}, {0x92, 0xc5, 0xde},
                                {0xd1, 0xe5, 0xf0}, {0xf7, 0xf7, 0xf7}, {0xfd, 0xdb, 0xc7},
                                {0xf4, 0xa5, 0x82}, {0xd6, 0x60, 0x4d}, {0xb2, 0x18, 0x2b}};

/// Linear between the stops, in the encoded values.
MapColour between_stops(std::span<const Stop> stops, double x) {
  const double at = std::clamp(x, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const auto first = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const double fraction = at - static_cast<double>(first);
  MapColour colour{0, 0, 0, 255};
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] =
        static_cast<std::uint8_t>(std::lround(stops[first][c] + (stops[first + 1][c] - stops[first][c]) * fraction));
  return colour;
}

} // namespace

MapColour sequential_colour(double x) {
  return between_stops(viridis, x);
}

MapColour diverging_colour(double x) {
  return between_stops(blue_to_red, (x + 1) / 2);
}

Image<std::uint8_t> colour_strip(MapColour (*colour)(double), double from, double to) {
  Image<std::uint8_t> strip(1, 256, 4);
  for (int y = 0; y < strip.height; ++y) {
    const MapColour at = colour(to + (from - to) * (y + 0.5) / strip.height);
    std::copy(at.begin(), at.end(), strip.at(0, y));
  }
  return strip;
}

} // namespace refraster
