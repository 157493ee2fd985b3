#pragma once
// Reading grids at a place that is an affine form, and interpolating between what was read.

#include "math/bounds/affine.h"

namespace refraster::inline REFRASTER_KIT {

template <class B>
Affine<B> join(const Affine<B>& x, const Affine<B>& y) {
  const Interval<B> range = join(x.range(), y.range());
  if (!x.form.is_finite() || !y.form.is_finite()) return Affine<B>(range);
  return Affine<B>::exactly(join(x.form, y.form), range);
}
template <class B>
Rgb<Affine<B>> join(const Rgb<Affine<B>>& a, const Rgb<Affine<B>>& b) {
  return {join(a.x, b.x), join(a.y, b.y), join(a.z, b.z)};
}

namespace affine_detail {

/// x less its centre.
template <class B>
AffineForm deviation(const Affine<B>& x) {
  AffineForm form = x.form;
  form.centre = 0;
  return form;
}

/// The greatest magnitude.
template <class B>
double size_of(const Interval<B>& x) {
  return std::max(std::abs(x.lo), std::abs(x.hi));
}

/// From a to b, before any rounding, by the better of two ways. In a + (b - a) f what a and b share cancels. In
/// c + (1 - f)(a - c) + f (b - c), with c the centre of a, what they do not share counts once, and not in b - a again.
template <class B>
AffineForm mix_form(const Affine<B>& a, const Affine<B>& b, const Affine<B>& f) {
  const double c = a.form.centre, reach = f.reach();
  const AffineForm difference = sum(b.form, a.form, -1);
  const AffineForm by_difference = sum(a.form, product(difference, difference.radius(), f.form, reach), 1);
  const AffineForm from_a = deviation(a), from_b = scaled(b.form, 1, {-c}), rest = scaled(f.form, -1, {1.0});
  const AffineForm both =
      sum(product(rest, upward(reach), from_a, from_a.radius()), product(f.form, reach, from_b, from_b.radius()), 1);
  const AffineForm by_parts = scaled(both, 1, {c});
  return by_parts.rest < by_difference.rest ? by_parts : by_difference;
}

} // namespace affine_detail

/// As the plain formula a + (b - a) f: b - a and its product are rounded, by at most 2 r + r^2 of |b - a| f together,
/// and the sum.
template <class B>
Affine<B> mix(const Affine<B>& a, const Affine<B>& b, const Affine<B>& f) {
  using namespace affine_detail;
  if (a.is_point() && b.is_point() && a.lo == b.lo) return a;
  const Interval<B> difference = b.range() - a.range(), range = a.range() + difference * f.range();
  if (!std::isfinite(range.width()) || !f.form.is_finite()) return Affine<B>(range);
  const double r = B::relative, most = size_of(f.range());
  const double error = upward((2 * r + r * r) * size_of(difference) * most + (most + 1) * B::absolute);
  return Affine<B>(mix_form(a, b, f), range, r, error + B::absolute);
}
template <class B>
Vec3<Affine<B>> mix(const Vec3<Affine<B>>& a, const Vec3<Affine<B>>& b, const Affine<B>& f) {
  return {mix(a.x, b.x, f), mix(a.y, b.y, f), mix(a.z, b.z, f)};
}
template <class B>
Vec4<Affine<B>> mix(const Vec4<Affine<B>>& a, const Vec4<Affine<B>>& b, const Affine<B>& f) {
  return {mix(a.x, b.x, f), mix(a.y, b.y, f), mix(a.z, b.z, f), mix(a.w, b.w, f)};
}

namespace affine_detail {

/// c0 + c1 x + c2 x^2 + c3 x^3 around m, for |x - m| <= reach: with X = x - m,
///     p(m) + p'(m) X + (c2 + 3 c3 m) X^2 + c3 X^3.
inline AffineForm cubic_form(const std::array<Bounds, 4>& c, const AffineForm& x, double reach) {
  const Bounds m(x.centre), squared(0, upward(reach * reach)), cubed = squared * Bounds(-reach, reach);
  const Bounds at_m = c[0] + m * (c[1] + m * (c[2] + m * c[3]));
  const Bounds derivative = c[1] + m * (Bounds(2.0) * c[2] + Bounds(3.0) * m * c[3]);
  const double slope = derivative.lo / 2 + derivative.hi / 2;
  const Bounds offset = at_m - Bounds(slope) * m + (derivative - Bounds(slope)) * Bounds(-reach, reach) +
                        (c[2] + Bounds(3.0) * m * c[3]) * squared + c[3] * cubed;
  return std::isfinite(offset.width()) ? scaled(x, slope, offset) : AffineForm::unknown();
}

/// The Catmull-Rom spline, before any rounding: that through the centres, a cubic in f, and the weights times what the
/// four deviate from them. The weights, in powers of f:
///     (-1/2 f + f^2 - 1/2 f^3,  1 - 5/2 f^2 + 3/2 f^3,  1/2 f + 2 f^2 - 3/2 f^3,  -1/2 f^2 + 1/2 f^3).
template <class B>
AffineForm cubic_mix_form(const std::array<const Affine<B>*, 4>& tap, const Affine<B>& f) {
  constexpr double weight[4][4] = {{0, -0.5, 1, -0.5}, {1, 0, -2.5, 1.5}, {0, 0.5, 2, -1.5}, {0, 0, -0.5, 0.5}};
  const double reach = f.reach();
  std::array<Bounds, 4> c = {Bounds(tap[1]->form.centre), Bounds(0.0), Bounds(0.0), Bounds(0.0)};
  AffineForm deviations;
  for (std::size_t i = 0; i < 4; ++i) {
    // In each power the weights add up to 0: only the distance to the second centre counts.
    const Bounds centre = Bounds(tap[i]->form.centre) - Bounds(tap[1]->form.centre);
    for (std::size_t k = 1; k < 4; ++k) c[k] += Bounds(weight[i][k]) * centre;
    if (tap[i]->is_point()) continue;
    const AffineForm w = cubic_form(
        {Bounds(weight[i][0]), Bounds(weight[i][1]), Bounds(weight[i][2]), Bounds(weight[i][3])}, f.form, reach);
    const AffineForm from_centre = deviation(*tap[i]);
    deviations = sum(deviations, product(w, w.radius(), from_centre, from_centre.radius()), 1);
  }
  return sum(cubic_form(c, f.form, reach), deviations, 1);
}

} // namespace affine_detail

/// As the plain formula, for f in [0, 1]. With D the greatest distance between two of the four, what it adds to b comes
/// from terms that are 8 D at most, taken all as positive: half a D of the slope, 3 D + D + D / 2 of the square, and of
/// the cube D / 2 + D / 2 + 2 D. Each goes through no more than nine operations, which lose (1 + r)^9 - 1 <= 9 r +
/// 40 r^2 of it, and the last sum loses r of itself. Each of fourteen operations may lose `absolute`, six times if it
/// is the rise, which goes into both powers.
template <class B>
Vec4<Affine<B>> mix_cubic(const Vec4<Affine<B>>& a, const Vec4<Affine<B>>& b, const Vec4<Affine<B>>& c,
                          const Vec4<Affine<B>>& d, const Affine<B>& f) {
  using namespace affine_detail;
  const auto ranges = [](const Vec4<Affine<B>>& v) {
    return Vec4<Interval<B>>(v.x.range(), v.y.range(), v.z.range(), v.w.range());
  };
  const Vec4<Interval<B>> range = mix_cubic(ranges(a), ranges(b), ranges(c), ranges(d), f.range());
  const bool inside = f.form.is_finite() && f.lo >= 0 && f.hi <= 1;
  const auto component = [&](const Affine<B>& w, const Affine<B>& x, const Affine<B>& y, const Affine<B>& z,
                             const Interval<B>& within) {
    const auto hull = Interval<B>::hull({w.range(), x.range(), y.range(), z.range()});
    if (hull.is_point()) return x;
    if (!inside || !std::isfinite(within.width())) return Affine<B>(within);
    const double r = B::relative, apart = upward(hull.hi - hull.lo);
    const double error = upward((9 * r + 40 * r * r) * 8 * apart + 14 * 6 * B::absolute);
    return Affine<B>(cubic_mix_form<B>({&w, &x, &y, &z}, f), within, r, error);
  };
  return {component(a.x, b.x, c.x, d.x, range.x), component(a.y, b.y, c.y, d.y, range.y),
          component(a.z, b.z, c.z, d.z, range.z), component(a.w, b.w, c.w, d.w, range.w)};
}

/// What may be any value.
template <int components, class B>
auto anything_like(const glm::vec<components, Affine<B>, glm::defaultp>&) {
  return glm::vec<components, Affine<B>, glm::defaultp>(Affine<B>::anything());
}

template <class B>
Affine<B> with_range(const Affine<B>&, const Interval<B>& range) {
  return Affine<B>(range);
}
/// With the whole form, of which only the part inside counts as range: so that a value that is read is a slope times
/// the place, and what holds all cells' values still is.
template <class B>
Affine<B> within_cell(const Affine<B>& x, std::int32_t index) {
  const Interval<B> inside = within_cell(x.range(), index);
  return (x - Affine<B>(index)).clipped(inside.lo, inside.hi);
}

namespace affine_detail {

template <class B, std::size_t dimensions>
auto walk_of(const std::array<Affine<B>, dimensions>& place, const std::array<GridAxis, dimensions>& axes) {
  return CellWalk<Affine<B>, dimensions>(place, axes, [](const Affine<B>& x) { return x.range(); });
}

} // namespace affine_detail

/// What is read in any of the cells; where the budget has a limit and they have more samples, nothing is known.
template <class B, std::size_t dimensions, class Read>
auto read_walk(CellWalk<Affine<B>, dimensions>& walk, const Read& read) {
  auto value = read(walk.cells());
  if constexpr (requires {
                  B::max_samples;
                  anything_like(value);
                }) {
    constexpr std::int64_t samples = [] {
      if constexpr (requires { Read::samples; }) return Read::samples;
      else return std::int64_t{8};
    }();
    if (walk.count() > B::max_samples / samples) return anything_like(value);
  }
  while (walk.next()) value = join(value, read(walk.cells()));
  return value;
}

/// See read_grid.
template <class B, std::size_t dimensions, class Read>
auto read_every_cell(const std::array<Affine<B>, dimensions>& place, const std::array<GridAxis, dimensions>& axes,
                     const Read& read) {
  auto walk = affine_detail::walk_of(place, axes);
  return read_walk(walk, read);
}

/// See read_nearest: of one of the cells on each path that is followed (Forks); while none is, of all.
template <class B, std::size_t dimensions, class Read>
  requires requires {
    B::decided(Certainty::unknown);
  }
auto read_one_cell(const std::array<Affine<B>, dimensions>& place, const std::array<GridAxis, dimensions>& axes,
                   const Read& read) {
  auto walk = affine_detail::walk_of(place, axes);
  for (std::int64_t left = walk.count(); left > 1; --left) {
    const Certainty is_this = B::decided(Certainty::unknown);
    if (is_this == Certainty::yes) return read(walk.cells());
    if (is_this == Certainty::unknown) {
      walk.start();
      return read_walk(walk, read);
    }
    walk.next();
  }
  return read(walk.cells());
}

} // namespace refraster::inline REFRASTER_KIT
