#pragma once
// Angles as people write them, in degrees or as fractions of a turn. Plain double: once a scene, or a vertex of a
// shape.

#include "math/elementary/double_double.h"
#include "math/elementary/polynomial.h"
#include "math/elementary/ulp_bound.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace refraster::inline REFRASTER_KIT {

inline constexpr UlpBound sin_degrees_error = {0.75, 0.6}, cos_degrees_error = {0.75, 0.6},
                          tan_degrees_error = {1.0, 0.6};

inline constexpr double radians_per_degree = 0x1.1df46a2529d39p-6;

constexpr double radians(double degrees) {
  return degrees * radians_per_degree;
}

/// An angle as quarter turns and a rest in [-45, 45] degrees, of which sine and cosine are known to twice the
/// precision.
struct QuarterTurns {
  int quarters; // modulo 4: in 0 .. 3
  DoubleDouble<double> sine, cosine;
};

/// For a finite angle; NaN and infinity count as 0.
inline QuarterTurns quarter_turns(double angle) {
  if (!std::isfinite(angle)) angle = 0;
  // Exact: IEEE 754 defines the remainder of the nearest quotient without rounding. Of the quotient it gives only the
  // last bits, but no more are needed; in two's complement, which is right for negative ones too.
  int quotient = 0;
  const double rest = std::remquo(angle, 90.0, &quotient);
  const int quarters = quotient & 3;
  if (std::abs(rest) == 30)
    return {quarters, {std::copysign(0.5, rest), 0}, {0x1.bb67ae8584caap-1, 0x1.cec95d0b5c1e3p-55}};
  if (std::abs(rest) == 45) {
    const DoubleDouble<double> root_of_half = {0x1.6a09e667f3bcdp-1, -0x1.bdd3413b26456p-55};
    const double sign = std::copysign(1.0, rest);
    return {quarters, {sign * root_of_half.hi, sign * root_of_half.lo}, root_of_half};
  }
  // x + x_low = rest in radians: rest pi / 180.
  const DoubleDouble<double> product = two_product(rest, radians_per_degree);
  const double x = product.hi, x_low = product.lo + rest * 0x1.5c1d8becdd291p-62, x2 = x * x;
  // (sin(x) / x - 1) / x^2 within 9.3e-18, (cos(x) - 1 + x^2/2) / x^4 within 2.4e-18, for |x| <= pi/4.
  constexpr std::array s = {-0x1.5555555555555p-3, 0x1.1111111111110p-7,   -0x1.a01a01a019938p-13,
                            0x1.71de3a5460921p-19, -0x1.ae645412bae2cp-26, 0x1.61217f007cddep-33,
                            -0x1.ab17cc3395652p-41};
  constexpr std::array c = {0x1.5555555555555p-5,   -0x1.6c16c16c16967p-10, 0x1.a01a019f4eb44p-16,
                            -0x1.27e4fa17db697p-22, 0x1.1eeb68e764229p-29,  -0x1.907da02fc4a0fp-37};
  const DoubleDouble<double> sine = fast_two_sum(x, x * x2 * polynomial(x2, s) + x_low * (1 - x2 / 2));
  const DoubleDouble<double> square_of_x = two_product(x, x);
  const DoubleDouble<double> one_minus = fast_two_sum(1.0, -square_of_x.hi / 2);
  const double cosine_rest = x2 * x2 * polynomial(x2, c) - square_of_x.lo / 2 - x * x_low;
  return {quarters, sine, fast_two_sum(one_minus.hi, one_minus.lo + cosine_rest)};
}

/// Sine and cosine of an angle in degrees, exact where they are 0, 1/2 or 1, and then never -0.
struct SineCosine {
  double sine, cosine;
};
inline SineCosine sine_cosine(const QuarterTurns& at) {
  const double sine = at.sine.hi + 0.0, minus_sine = 0.0 - at.sine.hi, cosine = at.cosine.hi;
  switch (at.quarters) {
  case 0:
    return {sine, cosine};
  case 1:
    return {cosine, minus_sine};
  case 2:
    return {minus_sine, -cosine};
  default:
    return {-cosine, sine};
  }
}

inline SineCosine sine_cosine_of_degrees(double angle) {
  return sine_cosine(quarter_turns(angle));
}
/// Of part / whole of a full turn, 0 <= part <= whole, whole > 0. The angle is brought to within an eighth of a turn in
/// integers, so that points of a circle are exactly as symmetrical as their fractions of a turn.
inline SineCosine sine_cosine_of_turn(int part, int whole) {
  const std::int64_t quarters = (8 * std::int64_t{part} + whole) / (2 * std::int64_t{whole}); // nearest
  QuarterTurns at = quarter_turns(90.0 * static_cast<double>(4 * std::int64_t{part} - quarters * whole) / whole);
  at.quarters = static_cast<int>((at.quarters + quarters) & 3);
  return sine_cosine(at);
}

inline double sin_degrees(double angle) {
  return sine_cosine_of_degrees(angle).sine;
}
inline double cos_degrees(double angle) {
  return sine_cosine_of_degrees(angle).cosine;
}
/// +-infinity at odd multiples of 90 degrees.
inline double tan_degrees(double angle) {
  const QuarterTurns at = quarter_turns(angle);
  const bool swapped = at.quarters % 2 == 1; // tan(x + 90) = -1 / tan(x)
  const DoubleDouble<double> above = swapped ? at.cosine : at.sine, below = swapped ? at.sine : at.cosine;
  const double quotient = above.hi / below.hi;
  if (!std::isfinite(quotient)) return quotient;
  const DoubleDouble<double> back = two_product(quotient, below.hi);
  const double rest = ((above.hi - back.hi) - back.lo) + (above.lo - quotient * below.lo);
  const double tangent = quotient + rest / below.hi;
  return swapped ? -tangent : tangent + 0.0;
}

} // namespace refraster::inline REFRASTER_KIT
