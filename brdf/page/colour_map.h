#pragma once
// Numbers as colours.

#include <refraster/image.h>

#include <array>
#include <cstdint>

namespace refraster {

using MapColour = std::array<std::uint8_t, 4>; // red, green, blue, alpha, as sRGB has them

/// From dark blue to yellow, of equal steps to the eye and to those who see few colours: "viridis" (van der Walt,
/// Smith, 2015; CC0). x in [0, 1], clamped.
MapColour sequential_colour(double x);

/// From blue (-1) over white (0) to red (1), clamped: "RdBu" of ColorBrewer (Brewer, 2003), the other way round.
MapColour diverging_colour(double x);

/// A strip of all colours, the first at the bottom: a column of an image, 256 pixels high.
Image<std::uint8_t> colour_strip(MapColour (*colour)(double), double from, double to);

} // namespace refraster
