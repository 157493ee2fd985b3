#pragma once
// Angles as people write them, in degrees: rotations and fields of view of a scene. Plain double, once per scene.

#include "math/polynomial.h"
#include "math/twofold.h"
#include "math/ulp_bound.h"

#include <array>
#include <cmath>

namespace refraster {

inline constexpr UlpBound sin_degrees_error = {0.75, 0.6}, cos_degrees_error = {0.75, 0.6},
                          tan_degrees_error = {2.0, 1.5};

inline constexpr double radians_per_degree = 0x1.1df46a2529d39p-6;

constexpr double radians(double degrees) {
  return degrees * radians_per_degree;
}
constexpr double degrees(double radians) {
  return radians / radians_per_degree;
}

/// Sine and cosine of an angle, both exact where they are 0, 1/2 or 1.
struct SineCosine {
  double sine, cosine;
};

/// For a finite angle; NaN and infinity count as 0.
inline SineCosine sine_cosine_of_degrees(double angle) {
  if (!std::isfinite(angle)) return {0, 1};
  // Exact: IEEE 754 defines the remainder of the nearest quotient without rounding. Only the quotient's last bits
  // matter.
  int quadrant = 0;
  const double rest = std::remquo(angle, 90.0, &quadrant); // in [-45, 45]

  double sine, cosine;
  if (std::abs(rest) == 30) {
    sine = std::copysign(0.5, rest), cosine = 0x1.bb67ae8584caap-1; // sqrt(3)/2
  } else if (std::abs(rest) == 45) {
    sine = std::copysign(0x1.6a09e667f3bcdp-1, rest), cosine = 0x1.6a09e667f3bcdp-1; // sqrt(1/2)
  } else {
    // x + x_low = rest in radians, to twice the precision: rest pi / 180.
    const Twofold<double> per_degree = {radians_per_degree, 0x1.5c1d8becdd291p-62};
    const Twofold<double> product = wide_product(rest, per_degree.hi);
    const double x = product.hi, x_low = product.lo + rest * per_degree.lo, x2 = x * x;
    // (sin(x) / x - 1) / x^2 within 9.3e-18, (cos(x) - 1 + x^2/2) / x^4 within 2.4e-18, for |x| <= pi/4.
    constexpr std::array s = {-0x1.5555555555555p-3, 0x1.1111111111110p-7,   -0x1.a01a01a019938p-13,
                              0x1.71de3a5460921p-19, -0x1.ae645412bae2cp-26, 0x1.61217f007cddep-33,
                              -0x1.ab17cc3395652p-41};
    constexpr std::array c = {0x1.5555555555555p-5,   -0x1.6c16c16c16967p-10, 0x1.a01a019f4eb44p-16,
                              -0x1.27e4fa17db697p-22, 0x1.1eeb68e764229p-29,  -0x1.907da02fc4a0fp-37};
    sine = x + (x * x2 * polynomial(x2, s) + x_low * (1 - x2 / 2));
    const Twofold<double> square_of_x = wide_product(x, x);
    const Twofold<double> one_minus = quick_sum(1.0, -square_of_x.hi / 2);
    cosine = one_minus.hi + (one_minus.lo + (x2 * x2 * polynomial(x2, c) - square_of_x.lo / 2 - x * x_low));
  }
  switch (quadrant & 3) { // two's complement: right for negative quotients too. `+ 0.0` makes a negative zero positive.
  case 0:
    return {sine, cosine};
  case 1:
    return {cosine, 0.0 - sine};
  case 2:
    return {0.0 - sine, 0.0 - cosine};
  default:
    return {0.0 - cosine, sine + 0.0};
  }
}

inline double sin_degrees(double angle) {
  return sine_cosine_of_degrees(angle).sine;
}
inline double cos_degrees(double angle) {
  return sine_cosine_of_degrees(angle).cosine;
}
/// +-infinity at odd multiples of 90 degrees.
inline double tan_degrees(double angle) {
  const SineCosine at = sine_cosine_of_degrees(angle);
  return at.sine / at.cosine;
}

} // namespace refraster
