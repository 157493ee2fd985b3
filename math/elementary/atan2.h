#pragma once

#include "math/elementary/double_double.h"
#include "math/elementary/polynomial.h"
#include "math/elementary/ulp_bound.h"

#include <numbers>

namespace refraster::inline REFRASTER_KIT {

template <class F>
inline constexpr UlpBound atan2_error = {0.85, 0.56}; // results below min_two_product: 2

inline constexpr DoubleDouble<double> quarter_pi = {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55};

/// The angle of (x, y) against the x axis in radians, in (-pi, pi], or -pi for y = -0 and x < 0. atan2(+-0, 0) = +-0,
/// whatever the sign of x = 0 is. An infinite x or y is infinitely longer than a finite one, and as long as the other.
/// NaN counts as 0. Error: atan2_error.
template <Lanes T>
  requires(!is_fast<T>)
T atan2(const T& y, const T& x) {
  using F = RealOf<T>;
  const T ax = max(abs(x), T(0)), ay = max(abs(y), T(0));
  const T largest(std::numeric_limits<F>::max());
  const T unscaled_long = max(ax, ay), unscaled_short = min(ax, ay);
  T longer = unscaled_long, shorter = unscaled_short;
  // Far from the borders of the range scaling would change no bit.
  constexpr F ordinary = sizeof(F) == 4 ? F(0x1p40) : F(0x1p200);
  if (any(!((shorter >= T(1 / ordinary)) & (longer <= T(ordinary))))) {
    const MaskOf<T> infinite = unscaled_long > largest;
    // A power of two, exact: quotients and their rests neither overflow nor lose bits to subnormals on the way.
    const T scale = reciprocal_binade(unscaled_long);
    longer = select(infinite, T(1), select(unscaled_long > T(0), unscaled_long * scale, T(1)));
    shorter = select(infinite, select(unscaled_short > largest, T(1), T(0)), unscaled_short * scale);
  }

  // atan(shorter / longer), in [0, pi/4]: above pi/8 as pi/4 - atan((longer - shorter) / (longer + shorter)).
  const MaskOf<T> steep = shorter > longer * as<T>(0x1.a827999fcef32p-2); // tan(pi/8)
  const DoubleDouble<T> sum = fast_two_sum(longer, shorter), gap = fast_two_sum(longer, -shorter);
  const DoubleDouble<T> numerator = {select(steep, -gap.hi, shorter), select(steep, -gap.lo, T(0))};
  const DoubleDouble<T> denominator = {select(steep, sum.hi, longer), select(steep, sum.lo, T(0))};
  const T reciprocal = T(1) / denominator.hi;
  const T a = numerator.hi * reciprocal;
  const DoubleDouble<T> back = two_product(a, denominator.hi);
  const T rest = (((numerator.hi - back.hi) - back.lo) + (numerator.lo - a * denominator.lo)) * reciprocal;
  const T a2 = a * a;
  T tail; // (atan(a) / a - 1) / a^2
  if constexpr (sizeof(F) == 4) {
    // Within 6.6e-10 / a^2 for |a| <= tan(pi/8).
    constexpr std::array p = {-0x1.5555495d081f7p-2, 0x1.9991ad7229618p-3, -0x1.23b6bc095629ep-3, 0x1.b2024322b62b6p-4,
                              -0x1.f256997f256b5p-5};
    tail = polynomial(a2, p);
  } else {
    // Within 2.3e-18 / a^2.
    constexpr std::array p = {-0x1.555555555553dp-2, 0x1.99999999958eap-3, -0x1.24924922b11c9p-3, 0x1.c71c70e7a15d1p-4,
                              -0x1.745cf90b0ab9cp-4, 0x1.3b111c63d2e52p-4, -0x1.10ebdd983eedcp-4, 0x1.df11672da6552p-5,
                              -0x1.9cdc255222d70p-5, 0x1.37ed3bbb8ec62p-5, -0x1.259d3d85c2dc3p-6};
    tail = polynomial(a2, p);
  }
  const T correction = rest + a * a2 * tail;

  // The octants: y longer than x turns the angle to pi/2 - angle, x < 0 to pi - angle. In quarters of pi:
  //   base = steep ? 1 : 0;   base, sign = 2 - base, -sign;   base, sign = 4 - base, -sign.
  T quarters = select(steep, T(1), T(0)), sign(1);
  const MaskOf<T> upright = ay > ax;
  quarters = select(upright, T(2) - quarters, quarters);
  sign = select(upright, -sign, sign);
  const MaskOf<T> backward = x < T(0);
  quarters = select(backward, T(4) - quarters, quarters);
  sign = select(backward, -sign, sign);
  // pi/4 as a number that ends in zeros, so that 3 times it is exact, plus what is missing. (The double ends so
  // itself.)
  constexpr F high = sizeof(F) == 4 ? F(0x1.921fbp-1) : F(quarter_pi.hi);
  constexpr F low = F((quarter_pi.hi - static_cast<double>(high)) + quarter_pi.lo);
  const DoubleDouble<T> angle = fast_two_sum(quarters * T(high), sign * a);
  const T result = angle.hi + (angle.lo + (quarters * T(low) + sign * correction));
  return with_sign(result, y);
}

/// The same within 4.4e-6 of the angle, and a few roundings.
template <Lanes T>
  requires(is_fast<T>)
T atan2(const T& y, const T& x) {
  // atan(a) / a in a^2, within 4.4e-6 of it for a <= 1.
  constexpr std::array p = {0x1.ffff6d6017f38p-1,  -0x1.54fc8ad72980dp-2, 0x1.90a9ac4720466p-3,
                            -0x1.f098eb21297f3p-4, 0x1.d6dbbea4b4fddp-5,  -0x1.b9bbdc3417257p-7};
  const T largest(std::numeric_limits<RealOf<T>>::max());
  const T ax = min(max(abs(x), T(0)), largest), ay = min(max(abs(y), T(0)), largest);
  const T longer = max(ax, ay), shorter = min(ax, ay);
  const T a = shorter / select(longer > T(0), longer, T(1));
  const T octant = a * polynomial(square(a), p);
  const T quadrant = select(ay > ax, as<T>(std::numbers::pi / 2) - octant, octant);
  return with_sign(select(x < T(0), as<T>(std::numbers::pi) - quadrant, quadrant), y);
}

} // namespace refraster::inline REFRASTER_KIT
