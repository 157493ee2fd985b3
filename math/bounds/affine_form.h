#pragma once
// Real numbers that depend on shared unknowns: arithmetic on their first-order forms, without any device's rounding.
// Comba, Stolfi, "Affine arithmetic and its applications to computer graphics", 1993; de Figueiredo, Stolfi,
// "Affine arithmetic: concepts and applications", 2004.

#include "math/bounds/interval.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace refraster::inline REFRASTER_KIT {

/// centre + sum of slope[k] e_k + something of at most `rest`. The symbols e_k lie anywhere in [-1, 1] and mean the
/// same in all forms that are computed with; nothing is known of the rest but its size. A form of which nothing is
/// known has an infinite rest. Every operation holds the exact real result: what double loses on the way goes to
/// the rest.
struct AffineForm {
  /// Of a fragment: the two of the sample's shift, that of 1/w, and one for each component of position, normal and
  /// texture coordinates. One is left; a multiple of four fills registers.
  static constexpr std::size_t symbols = 12;

  double centre = 0;
  std::array<double, symbols> slope{};
  double rest = 0;

  static AffineForm unknown() {
    AffineForm form;
    form.rest = std::numeric_limits<double>::infinity();
    return form;
  }
  /// Any number of [lo, hi], which are finite.
  static AffineForm anywhere_in(double lo, double hi) {
    using namespace interval_detail;
    AffineForm form;
    form.centre = lo / 2 + hi / 2;
    form.rest = lo == hi ? 0 : std::max(step_up(hi - form.centre), step_up(form.centre - lo));
    return form;
  }

  bool is_finite() const { return std::isfinite(centre) && std::isfinite(rest); }
  /// How far a number may be from the centre.
  double radius() const;
};

namespace affine_detail {

using Bounds = Interval<DoubleArithmetic>;

/// Half of the distance from 1 to the next double: no result of an operation is farther from the exact one than this
/// times its own size, unless it underflows.
inline constexpr double rounding = 0x1p-53;

/// A bound that was computed in double, from numbers that are not negative and by fewer than 2^6 sums and products,
/// made one that holds: each of them loses at most 2^-53 of its result, and (1 - 2^-53)^-64 < 1 + 2^-46; or 2^-1074,
/// where it underflows.
inline double upward(double bound) {
  return bound * (1 + 0x1p-46) + 0x1p-1067;
}

} // namespace affine_detail

inline double AffineForm::radius() const {
  double sum = rest;
  for (const double s : slope) sum += std::abs(s);
  return affine_detail::upward(sum);
}

namespace affine_detail {

/// All that the form may be.
inline Bounds range_of(const AffineForm& form) {
  using namespace interval_detail;
  const double radius = form.radius();
  return {step_down(form.centre - radius), step_up(form.centre + radius)};
}

} // namespace affine_detail

/// x + sign y, sign being 1 or -1. Each coefficient is rounded once.
inline AffineForm sum(const AffineForm& x, const AffineForm& y, double sign) {
  AffineForm result;
  result.centre = x.centre + sign * y.centre;
  double size = std::abs(result.centre);
  for (std::size_t k = 0; k < AffineForm::symbols; ++k) {
    result.slope[k] = x.slope[k] + sign * y.slope[k];
    size += std::abs(result.slope[k]);
  }
  result.rest = affine_detail::upward(x.rest + y.rest + affine_detail::rounding * size);
  return result;
}

/// factor x + offset. Each slope is rounded once, the centre twice.
inline AffineForm scaled(const AffineForm& x, double factor, const Interval<DoubleArithmetic>& offset) {
  const AffineForm shift = AffineForm::anywhere_in(offset.lo, offset.hi);
  AffineForm result;
  const double centre = factor * x.centre;
  result.centre = centre + shift.centre;
  double size = std::abs(centre) + std::abs(result.centre);
  for (std::size_t k = 0; k < AffineForm::symbols; ++k) {
    result.slope[k] = factor * x.slope[k];
    size += std::abs(result.slope[k]);
  }
  result.rest = affine_detail::upward(std::abs(factor) * x.rest + shift.rest + affine_detail::rounding * size);
  return result;
}

/// a x + b y. Two products and their sum are rounded for each coefficient.
inline AffineForm combined(double a, const AffineForm& x, double b, const AffineForm& y) {
  AffineForm result;
  double size = 0;
  const auto coefficient = [&](double of_x, double of_y) {
    const double p = a * of_x, q = b * of_y, both = p + q;
    size += std::abs(p) + std::abs(q) + std::abs(both);
    return both;
  };
  result.centre = coefficient(x.centre, y.centre);
  for (std::size_t k = 0; k < AffineForm::symbols; ++k) result.slope[k] = coefficient(x.slope[k], y.slope[k]);
  result.rest = affine_detail::upward(std::abs(a) * x.rest + std::abs(b) * y.rest + affine_detail::rounding * size);
  return result;
}

/// x y, with x and y no farther from their centres than x_reach and y_reach say.
///
/// With x = c + X and y = d + Y it is c d + d X + c Y + X Y. What X and Y have in common is known to be squares:
///     X Y = sum of x_k y_k e_k^2 + the mixed products,   e_k^2 in [0, 1],
/// so that with D = sum of x_k y_k and A = sum of |x_k y_k| the squares lie within A / 2 of D / 2, and the mixed
/// products, with those of the rests, within |X| |Y| - A of 0. Where the reaches are short that is no better than
/// within x_reach y_reach of 0.
inline AffineForm product(const AffineForm& x, double x_reach, const AffineForm& y, double y_reach) {
  using namespace affine_detail;
  AffineForm result;
  double size = 0, shared = 0, shared_size = 0, x_radius = x.rest, y_radius = y.rest;
  for (std::size_t k = 0; k < AffineForm::symbols; ++k) {
    const double p = x.centre * y.slope[k], q = y.centre * x.slope[k], square = x.slope[k] * y.slope[k];
    result.slope[k] = p + q;
    size += std::abs(p) + std::abs(q) + std::abs(result.slope[k]);
    shared += square, shared_size += std::abs(square);
    x_radius += std::abs(x.slope[k]), y_radius += std::abs(y.slope[k]);
  }
  // A is above its exact value by less than 2^-46 of it, and D as near: that much is given back.
  double quadratic = upward(x_radius * y_radius) - shared_size / 2 + 0x1p-45 * shared_size;
  const double by_reach = upward(x_reach * y_reach);
  if (by_reach < quadratic) quadratic = by_reach, shared = 0;
  const double centres = x.centre * y.centre;
  result.centre = centres + shared / 2;
  size += std::abs(centres) + std::abs(result.centre);
  result.rest = upward(std::abs(x.centre) * y.rest + std::abs(y.centre) * x.rest + quadratic + rounding * size);
  return result;
}

/// x^2 = 2 c x - c^2 + X^2 with X^2 in [0, radius^2], for x = c + X.
inline AffineForm square(const AffineForm& x) {
  using namespace affine_detail;
  const double radius = x.radius();
  return scaled(x, 2 * x.centre, Bounds(0, upward(radius * radius)) - Bounds(x.centre) * Bounds(x.centre));
}

/// What holds both. On the way from the coefficients of x to those of y, `apart` in all, at t of it, the rest must hold
/// that of x and t apart, and that of y and (1 - t) apart: the least where both are as much. So the smaller of two
/// balls that lies within the other changes nothing, however often.
inline AffineForm join(const AffineForm& x, const AffineForm& y) {
  double apart = std::abs(x.centre - y.centre);
  for (std::size_t k = 0; k < AffineForm::symbols; ++k) apart += std::abs(x.slope[k] - y.slope[k]);
  const double t = apart > 0 ? std::clamp((y.rest - x.rest) / apart / 2 + 0.5, 0.0, 1.0) : 0;
  AffineForm result;
  double from_x = x.rest, from_y = y.rest;
  const auto coefficient = [&](double of_x, double of_y) {
    const double between = of_x + t * (of_y - of_x);
    from_x += std::abs(between - of_x), from_y += std::abs(between - of_y);
    return between;
  };
  result.centre = coefficient(x.centre, y.centre);
  for (std::size_t k = 0; k < AffineForm::symbols; ++k) result.slope[k] = coefficient(x.slope[k], y.slope[k]);
  result.rest = affine_detail::upward(std::max(from_x, from_y));
  return result;
}

} // namespace refraster::inline REFRASTER_KIT
