#pragma once
// The transfer curve of sRGB, IEC 61966-2-1, and its inverse: the same bits everywhere.

#include "math/elementary.h"

namespace refraster::inline REFRASTER_KIT {

/// The curve, of a linear x: 1 is white. Beyond [0, 1] it goes on.
template <class T>
T srgb_encoded(const T& x) {
  return select(x <= as<T>(0.0031308), as<T>(12.92) * x, as<T>(1.055) * pow(x, 1 / 2.4) - as<T>(0.055));
}

/// Its inverse. NaN stays NaN in both.
inline double srgb_decoded(double y) {
  return y <= 0.04045 ? y / 12.92 : pow((y + 0.055) / 1.055, 2.4);
}

} // namespace refraster::inline REFRASTER_KIT
