#pragma once
// A picture of where two images differ.

#include "verify/compare.h"

#include <array>

namespace refraster {

using Rgb8 = std::array<std::uint8_t, 3>;

/// The colour of a share t in [0, 1]: from black over violet, red and orange to pale yellow. Each step is lighter than
/// the one before, so that the order survives grey printing and colour blindness.
/// Ten stops of "inferno" (S. van der Walt, N. Smith, matplotlib, CC0), linear in between.
Rgb8 heat_colour(double t);

/// The colour of pixels without a difference (NaN, infinity): not on the ramp.
inline constexpr Rgb8 incomparable_colour = {0, 255, 255};

/// One pixel each: black where equal; else by the value that differs most, on a logarithmic ramp from 0 to found.max,
/// so that one level is seen beside a hundred:
///     t = log(1 + d / level) / log(1 + max / level),     level = full_range / 255.
/// `found` is the comparison of these images.
Image<std::uint8_t> heat_image(const Image<float>& a, const Image<float>& b, const Comparison& found);

} // namespace refraster
