#pragma once
// The sRGB curve and its inverse, for values of image files.

#include <cmath>

namespace refraster {

/// IEC 61966-2-1: the linear value of s, 1 being white. Below 0 and above 1 the curve goes on; NaN stays NaN. By the C
/// library: unlike raster/explain, nothing here may have to be the same on every machine to the last bit.
inline double linear_from_srgb(double s) {
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

/// The curve itself, of a linear value: likewise.
inline double srgb_from_linear(double x) {
  return x <= 0.0031308 ? x * 12.92 : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

} // namespace refraster
