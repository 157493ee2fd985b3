#pragma once
// A picture of where two images differ.

#include <refraster/compare.h>

#include <array>

namespace refraster {

using Rgb8 = std::array<std::uint8_t, 3>;

/// The colour of a fraction t in [0, 1]: from black over violet, red and orange to pale yellow. Each step is lighter
/// than the one before, so that the order survives grey printing and colour blindness. Ten stops of "inferno" (S. van
/// der Walt, N. Smith, matplotlib, CC0), linear in between.
Rgb8 heat_colour(double t);

/// The colour of pixels without a difference (NaN, infinity): not on the ramp.
inline constexpr Rgb8 incomparable_colour = {0, 255, 255};

/// Where the ramp ends: at what is asked for, or else at the first of 1, 2, 5, 10, 20 ... that is not below found.max.
/// In the unit; 0 if nothing differs.
double heat_ramp_end(const Comparison& found, std::optional<double> asked = {});

/// One pixel each: black where equal; else by the value that differs most, on a logarithmic ramp from 0 to ramp_end, so
/// that one level is seen beside a hundred; what differs by more has the colour of its end:
///     t = log(1 + d / level) / log(1 + ramp_end / level),     level = full_range / 255.
Image<std::uint8_t> heat_image(const Image<float>& a, const Image<float>& b, const PixelScale& scale, double ramp_end);

} // namespace refraster
