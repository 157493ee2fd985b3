#include "math/half_of.h"

#include "math/scalar.h"

#define IMATH_HALF_NO_LOOKUP_TABLE // the header alone: nothing of Imath's is linked
#include <Imath/half.h>

#include <bit>
#include <cstdint>

namespace refraster {

namespace {

/// x as a float; where it is between two floats, the one whose last bit is set. A float has more than two digits more
/// than a half, so that rounding this one to a half gives what rounding x does: halfway cases stay what they are, and
/// nothing else becomes one. Boldo and Melquiond, "Emulation of FMA and correctly rounded sums: proved algorithms using
/// rounding to odd", 2008.
float rounded_to_odd(double x) {
  const auto nearest = static_cast<float>(x);
  const auto back = static_cast<double>(nearest);
  if (back == x) return nearest;
  auto bits = std::bit_cast<std::uint32_t>(nearest);
  if (abs(back) > abs(x)) --bits;
  return std::bit_cast<float>(bits | 1);
}

} // namespace

Half half_of(double x) {
  const double in_range = min(max(x, -Half::largest), Half::largest) + 0.0; // + 0 turns -0 into 0
  return {imath_float_to_half(rounded_to_odd(in_range))};
}

} // namespace refraster
