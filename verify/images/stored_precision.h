#pragma once
// How finely an image stores its values.

#include <cmath>

namespace refraster {

/// What rounding to the format of a file has done to a value, and whether it cuts off. In levels (1/255).
struct StoredPrecision {
  double step = 0;     // between neighbouring values: 1 for 8 bits, 1/257 for 16 bits; 0 for floating point, and for
                       // values that were computed from stored ones
  double absolute = 0; // at most so many levels from the value that was stored, plus
  double relative = 0; // so much of it

  static constexpr StoredPrecision integers(double full_scale) { return {255 / full_scale, 0.5 * 255 / full_scale, 0}; }
  static constexpr StoredPrecision floats(double roundoff) { return {0, 0, roundoff}; }

  /// Whether values below 0 and above 1 are stored as 0 and 1.
  constexpr bool saturates() const { return step > 0; }
};

} // namespace refraster
