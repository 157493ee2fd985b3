#pragma once
// A function of one variable as a line and what is left: the best one that the shape of the function gives.

#include "math/bounds/affine_form.h"
#include "math/bounds/interval_functions.h"

namespace refraster::inline REFRASTER_KIT {

enum class Shape { convex, concave };

/// f(x) - slope x lies in `offset` for all x of a range.
struct Curve {
  double slope = 0;
  Interval<DoubleArithmetic> offset;

  AffineForm of(const AffineForm& x) const { return scaled(x, slope, offset); }
};

/// Of a monotone f that is convex or concave over [x.lo, x.hi]. value(x) and derivative(x) enclose f and f' at a
/// number; touching(slope) is about where f' is that slope, and the nearer the narrower.
///
/// With the slope of the chord f - slope x has the same value at both ends, which for a convex f is its greatest.
/// At any u of the range the tangent lies below f, so that f - slope x is at least
///     f(u) - slope u + (f'(u) - slope)(x - u),
/// nearly constant where f'(u) is nearly the slope. For a concave f the same upside down. Neither needs an exact slope.
template <class Value, class Derivative, class Touching>
Curve curve(const Interval<DoubleArithmetic>& x, Shape shape, const Value& value, const Derivative& derivative,
            const Touching& touching) {
  using affine_detail::Bounds;
  const Bounds a(x.lo), b(x.hi), at_a = value(x.lo), at_b = value(x.hi);
  Curve result{0, Bounds::hull({at_a, at_b})};
  const double slope = (at_b.lo - at_a.lo) / (x.hi - x.lo);
  if (!std::isfinite(slope) || slope == 0) return result;
  double u = touching(slope);
  if (!(u > x.lo && u < x.hi)) u = x.lo / 2 + x.hi / 2;
  const Bounds line(slope);
  const Bounds ends = Bounds::hull({at_a - line * a, at_b - line * b});
  const Bounds tangent = value(u) - line * Bounds(u) + (derivative(u) - line) * (x - Bounds(u));
  const Bounds offset = shape == Shape::convex ? Bounds(std::min(tangent.lo, ends.hi), ends.hi)
                                               : Bounds(ends.lo, std::max(tangent.hi, ends.lo));
  if (std::isfinite(offset.width())) result = {slope, offset};
  return result;
}

/// sqrt(x), x >= 0.
inline Curve sqrt_curve(const Interval<DoubleArithmetic>& x) {
  using affine_detail::Bounds;
  return curve(
      x, Shape::concave, [](double y) { return sqrt(Bounds(y)); },
      [](double y) { return Bounds(0.5) / sqrt(Bounds(y)); }, [](double slope) { return 0.25 / (slope * slope); });
}

/// 1 / sqrt(x), x > 0. Its slope at x is -x^(-3/2) / 2.
inline Curve reciprocal_root_curve(const Interval<DoubleArithmetic>& x) {
  using affine_detail::Bounds;
  return curve(
      x, Shape::convex, [](double y) { return Bounds(1.0) / sqrt(Bounds(y)); },
      [](double y) { return Bounds(-0.5) / (Bounds(y) * sqrt(Bounds(y))); },
      [](double slope) { return exp2(-2.0 / 3 * log2(-2 * slope)); });
}

/// The natural logarithm of 2.
inline Interval<DoubleArithmetic> ln_2() {
  return Interval<DoubleArithmetic>::around(std::numbers::ln2, std::numeric_limits<double>::quiet_NaN());
}

/// 2^x, of an x whose power neither overflows nor is cut off.
inline Curve exp2_curve(const Interval<DoubleArithmetic>& x) {
  using affine_detail::Bounds;
  return curve(
      x, Shape::convex, [](double y) { return exp2(Bounds(y)); }, [](double y) { return exp2(Bounds(y)) * ln_2(); },
      [](double slope) { return log2(slope / std::numbers::ln2); });
}

/// log2(x), x > 0.
inline Curve log2_curve(const Interval<DoubleArithmetic>& x) {
  using affine_detail::Bounds;
  return curve(
      x, Shape::concave, [](double y) { return log2(Bounds(y)); },
      [](double y) { return Bounds(1.0) / (Bounds(y) * ln_2()); },
      [](double slope) { return 1 / (slope * std::numbers::ln2); });
}

/// x^s, x >= 0, s > 0: convex from s = 1 on, else concave. Its slope at x is s x^(s - 1). value(x) encloses x^s.
template <class Value>
Curve power_curve(const Interval<DoubleArithmetic>& x, double s, const Value& value) {
  using affine_detail::Bounds;
  return curve(
      x, s >= 1 ? Shape::convex : Shape::concave, value, [&](double y) { return Bounds(s) * value(y) / Bounds(y); },
      [&](double slope) { return exp2(log2(slope / s) / (s - 1)); });
}

/// (1 - x)^s, 0 <= x < 1, s > 0, likewise. value(x) encloses it.
template <class Value>
Curve complement_power_curve(const Interval<DoubleArithmetic>& x, double s, const Value& value) {
  using affine_detail::Bounds;
  return curve(
      x, s >= 1 ? Shape::convex : Shape::concave, value,
      [&](double y) { return Bounds(-s) * value(y) / (Bounds(1.0) - Bounds(y)); },
      [&](double slope) { return 1 - exp2(log2(-slope / s) / (s - 1)); });
}

/// atan(x) for |x| <= most. The slopes lie in [1 / (1 + most^2), 1]; with the middle one, what is left is odd and so at
/// most |x| times half of their range away from 0: most^3 / (2 (1 + most^2)).
inline Curve atan_curve(double most) {
  using affine_detail::Bounds;
  const Bounds least = Bounds(1.0) / (Bounds(1.0) + Bounds(most) * Bounds(most));
  const double slope = 0.5 + least.lo / 2;
  // Of |f'(x) - slope|, over all x: at one of the ends of the range.
  const double off = std::max((Bounds(1.0) - Bounds(slope)).hi, (Bounds(slope) - least).hi);
  const double rest = (Bounds(most) * Bounds(off)).hi;
  return {slope, {-rest, rest}};
}

} // namespace refraster::inline REFRASTER_KIT
