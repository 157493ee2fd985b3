#pragma once
// Parts of compare() of <refraster/compare.h>.

#include <refraster/compare.h>

namespace refraster {

/// The limits of one unit in the other.
CompareLimits converted(const CompareLimits& limits, CompareUnit from, CompareUnit to);

/// |b - a|: 0 for the same infinity, infinity where there is no difference.
double value_difference(float a, float b);

/// Of each pixel, that of the channel that differs most, in the unit. 1 channel.
Image<double> pixel_differences(const Image<float>& a, const Image<float>& b, const PixelScale& scale);

/// Of each pixel whether it is over the limit, as compare() counts it: 1 or 0. `differences`: of pixel_differences().
Image<std::uint8_t> pixels_over(const Image<float>& a, const Image<float>& b, const Image<double>& differences,
                                const PixelScale& scale, const CompareLimits& limits);

} // namespace refraster
