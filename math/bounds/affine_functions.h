#pragma once
// What a Number has beside + - * /, for bounds that remember where they come from. Every result is also in the range
// that an Interval has of it.

#include "math/bounds/affine_curve.h"
#include "math/bounds/affine_grid.h"

namespace refraster::inline REFRASTER_KIT {

namespace affine_detail {

template <class B>
Vec3<Interval<B>> ranges(const Vec3<Affine<B>>& a) {
  return {a.x.range(), a.y.range(), a.z.range()};
}

template <class B>
Bounds real_range(const Affine<B>& x) {
  return {x.lo, x.hi};
}

/// How much x^2 + y^2 + z^2 may be, and its form, before any rounding.
template <class B>
Affine<DoubleArithmetic> exact_squared_length(const Vec3<Affine<B>>& a) {
  const Bounds range = square(real_range(a.x)) + square(real_range(a.y)) + square(real_range(a.z));
  if (!std::isfinite(range.width())) return Affine<DoubleArithmetic>(range);
  const AffineForm form = sum(sum(square(a.x.form), square(a.y.form), 1), square(a.z.form), 1);
  return Affine<DoubleArithmetic>::exactly(form, range);
}

} // namespace affine_detail

template <class B>
Affine<B> select(Certainty m, const Affine<B>& x, const Affine<B>& y) {
  return m == Certainty::yes ? x : m == Certainty::no ? y : join(x, y);
}

/// y + max(x - y, 0). Of d in [low, high], low < 0 < high, max(d, 0) - slope d is least at 0, where it is 0, and
/// greatest at an end.
template <class B>
Affine<B> max(const Affine<B>& x, const Affine<B>& y) {
  using namespace affine_detail;
  const Certainty less = certainly_less(x, y);
  if (less != Certainty::unknown) return less == Certainty::yes ? y : x;
  const Interval<B> range = max(x.range(), y.range());
  if (!x.form.is_finite() || !y.form.is_finite()) return Affine<B>(range);
  const AffineForm d = sum(x.form, y.form, -1);
  const Bounds of_form = range_of(d), of_ends = real_range(x) - real_range(y);
  const Bounds low(std::max(of_form.lo, of_ends.lo)), high(std::min(of_form.hi, of_ends.hi));
  const double slope = std::clamp(high.hi / (high.hi - low.lo), 0.0, 1.0);
  if (std::isnan(slope)) return Affine<B>(range);
  const double most = std::max({(Bounds(-slope) * low).hi, ((Bounds(1.0) - Bounds(slope)) * high).hi, 0.0});
  return Affine<B>::exactly(sum(y.form, scaled(d, slope, {0, most}), 1), range);
}
template <class B>
Affine<B> min(const Affine<B>& x, const Affine<B>& y) {
  return -max(-x, -y);
}
template <class B>
Affine<B> abs(const Affine<B>& x) {
  return max(x, -x).clipped(0, std::numeric_limits<double>::infinity());
}
template <class B>
Affine<B> square(const Affine<B>& x) {
  const Interval<B> range = square(x.range());
  return x.form.is_finite() ? Affine<B>::computed(square(x.form), range) : Affine<B>(range);
}

/// The square root of what is not negative in x; 0 where nothing is.
template <class B>
Affine<B> sqrt(const Affine<B>& x) {
  const Interval<B> range = sqrt(x.range());
  if (!x.form.is_finite() || x.lo < 0 || x.is_point()) return Affine<B>(range);
  return Affine<B>(sqrt_curve({x.lo, x.hi}).of(x.form), range, B::root_relative, B::absolute);
}

/// Within a cell: x less its integer.
template <class B>
Affine<B> fraction(const Affine<B>& x) {
  const Interval<B> range = fraction(x.range());
  if (!x.form.is_finite() || x.lo < -cell_limit || x.hi > cell_limit) return Affine<B>(range);
  const std::int32_t index = floor_and_fraction(x.lo).index;
  if (index != floor_and_fraction(x.hi).index) return Affine<B>(range);
  return (x - Affine<B>(index)).clipped(range.lo, range.hi);
}

namespace affine_detail {

/// `result` with an error of so many units of 2 relative, as a function of the interval has (of_rising), and less by
/// what is cut off if the result may be as small as that.
template <class B>
Affine<B> with_units(const AffineForm& exact, const Interval<B>& range, double units) {
  const double cut = range.lo <= 0 ? std::ldexp(1 + 0x1p-20, static_cast<int>(B::cut_off)) : 0;
  return Affine<B>(exact, range, 2 * units * B::relative, 2 * std::max(units, 1.0) * B::absolute + cut);
}

} // namespace affine_detail

template <class B>
Affine<B> log2(const Affine<B>& x) {
  const Interval<B> range = log2(x.range());
  if (!x.form.is_finite() || x.is_point() || x.lo < B::smallest_normal) return Affine<B>(range);
  // A logarithm may be negative, and is not cut off.
  const double units = B::log2_units;
  return Affine<B>(log2_curve({x.lo, x.hi}).of(x.form), range, 2 * units * B::relative,
                   2 * std::max(units, 1.0) * B::absolute + B::log2_absolute);
}
template <class B>
Affine<B> exp2(const Affine<B>& x) {
  const Interval<B> range = exp2(x.range());
  const bool ordinary = x.lo > DoubleArithmetic::cut_off + 1 && x.hi < highest_power<double> - 1;
  if (!x.form.is_finite() || x.is_point() || !ordinary) return Affine<B>(range);
  return affine_detail::with_units<B>(exp2_curve({x.lo, x.hi}).of(x.form), range,
                                      interval_detail::exp2_units(x.range()));
}
/// What is not positive counts as 0.
template <class B>
Affine<B> pow(const Affine<B>& x, double s) {
  using affine_detail::Bounds;
  const Interval<B> range = pow(x.range(), s);
  if (range.is_point() || !x.form.is_finite() || x.is_point()) return Affine<B>(range);
  if constexpr (B::powers == Powers::by_logarithm) return exp2(as<Affine<B>>(s) * log2(max(x, Affine<B>(0.0))));
  const Affine<B> base = max(x, Affine<B>(0.0)).clipped(0, x.hi);
  const auto value = [s](double y) { return pow(Bounds(y), s); };
  return affine_detail::with_units<B>(power_curve({base.lo, base.hi}, s, value).of(base.form), range, B::pow_units);
}

/// a.b added up in any order, also fused: as that of ranges.
template <class B>
  requires(B::sums == Sums::in_any_order)
Affine<B> dot(const Vec3<Affine<B>>& a, const Vec3<Affine<B>>& b) {
  using namespace affine_detail;
  const Interval<B> range = dot(ranges(a), ranges(b));
  AffineForm form;
  double size = 0;
  for (int i = 0; i < 3; ++i) {
    form = sum(form, product(a[i].form, a[i].reach(), b[i].form, b[i].reach()), 1);
    size += size_of(a[i].range()) * size_of(b[i].range());
  }
  if (!form.is_finite()) return Affine<B>(range);
  const double r = B::relative;
  return Affine<B>(form, range, 0, upward((3 * r + 3 * r * r + r * r * r) * size + 5 * B::absolute));
}
template <class B>
  requires(B::sums == Sums::in_any_order)
Affine<B> squared_length(const Vec3<Affine<B>>& a) {
  using namespace affine_detail;
  const Interval<B> range = squared_length(ranges(a));
  const Affine<DoubleArithmetic> squared = exact_squared_length(a);
  if (!squared.form.is_finite()) return Affine<B>(range);
  const double r = B::relative;
  return Affine<B>(squared.form, range, (3 * r + 3 * r * r + r * r * r) * (1 + 0x1p-40), 5 * B::absolute);
}

namespace affine_detail {

/// What small_power loses in the budget's arithmetic of results r up to `most`, in absolute terms:
///     r (2 + 4 |log2 r|) u, which rises up to log2 r = 1/2 - 1 / ln 2, and there is 3.003 u at most;
/// and what is cut off.
template <class B>
double small_power_loss(double least, double most) {
  const double units = std::min(
      3.003, most * (small_power_error_at_1 - small_power_error_per_bit * log2(most + smallest_result<double>)));
  const double rising = most < 0.5202 ? units : 3.003;
  const double cut = std::ldexp(1 + 0x1p-20, static_cast<int>(B::cut_off));
  return upward(rising * B::relative) * (1 + 0x1p-20) + (least <= cut ? cut : 0);
}

/// small_power of an exact base, with the error that it has in double.
inline Bounds plain_power(const OnePlus<double>& base, double s) {
  const double r = small_power(base, s);
  const double units = small_power_error_at_1 - small_power_error_per_bit * log2(r + smallest_result<double>);
  const double relative = units * DoubleArithmetic::relative * (1 + 0x1p-20);
  const double cut = std::ldexp(1 + 0x1p-20, static_cast<int>(DoubleArithmetic::cut_off));
  return {std::max(r * (1 - relative), 0.0), std::max(std::min(r * (1 + relative), 1.0), cut)};
}

} // namespace affine_detail

/// As the plain function, for whatever vectors the boxes hold: near a = b by |a - b|^2 / 2, else by the dot product.
template <class B>
Affine<B> cosine_power(const Vec3<Affine<B>>& a, const Vec3<Affine<B>>& b, double s) {
  using namespace affine_detail;
  using T = Affine<B>;
  const Interval<B> range = cosine_power(ranges(a), ranges(b), s);
  if (range.is_point()) return T(range);
  if constexpr (B::powers == Powers::by_logarithm) return pow(max(dot(a, b), T(0)), s);
  const T half_square = T(0.5) * squared_length(a - b), dotted = dot(a, b);
  T cosine = dotted;
  if constexpr (std::same_as<B, DoubleArithmetic>) cosine = select(dotted > T(0.5), T(1) - half_square, dotted);
  const auto of = [&](const T& x, const Curve& power, double extra) {
    if (!x.form.is_finite()) return T(range);
    return T(power.of(x.form), range, 0, small_power_loss<B>(range.lo, range.hi) + extra);
  };
  const Certainty is_near = cosine > T(0.75);
  const auto near = [&] {
    const T q = min(half_square, T(0.25)).clipped(0, 0.25);
    return of(q, complement_power_curve({q.lo, q.hi}, s, [s](double y) { return plain_power({-y, 0}, s); }), 0);
  };
  const auto far = [&] {
    const T c = min(max(cosine, T(0)), T(0.75)).clipped(0, 0.75);
    const auto value = [s](double y) { return y > 0 ? plain_power(one_plus(y), s) : Bounds(0.0); };
    // What is below the smallest normal number counts as 0, or as it.
    const double zeroed = c.lo < B::smallest_normal ? value(B::smallest_normal).hi : 0;
    return of(c, power_curve({c.lo, c.hi}, s, value), zeroed);
  };
  return is_near == Certainty::yes ? near() : is_near == Certainty::no ? far() : join(near(), far());
}

namespace affine_detail {

/// The angle of (x, y) against the x axis before any rounding, in a box in which it does not jump: that of a point
/// (c, d) of the box, and from there atan(v / u), with u = c x + d y and v = c y - d x. Unknown where u may be 0.
template <class B>
AffineForm angle_form(const Affine<B>& y, const Affine<B>& x) {
  if (!x.form.is_finite() || !y.form.is_finite()) return AffineForm::unknown();
  const double c = std::clamp(x.form.centre, x.lo, x.hi), d = std::clamp(y.form.centre, y.lo, y.hi);
  const double scale = reciprocal_binade(max(abs(c), abs(d))), of_x = c * scale, of_y = d * scale; // |.| < 2
  const AffineForm u = combined(of_x, x.form, of_y, y.form), v = combined(of_x, y.form, -of_y, x.form);
  const Bounds u_range = range_of(u);
  if (!(u_range.lo > 0) || !std::isfinite(u_range.hi)) return AffineForm::unknown();
  const auto t = Affine<DoubleArithmetic>::exactly(v, range_of(v)) / Affine<DoubleArithmetic>::exactly(u, u_range);
  const double most = std::max(std::abs(t.lo), std::abs(t.hi));
  // A power of two changes no digit of c and d, unless they are subnormal.
  if (!std::isfinite(most) || of_x / scale != c || of_y / scale != d) return AffineForm::unknown();
  const Curve atan = atan_curve(most);
  return scaled(t.form, atan.slope, atan.offset + atan2(Bounds(of_y), Bounds(of_x)));
}

} // namespace affine_detail

template <class B>
Affine<B> atan2(const Affine<B>& y, const Affine<B>& x) {
  const Interval<B> range = atan2(y.range(), x.range());
  const bool may_be_below = std::signbit(y.lo), may_be_above = !std::signbit(y.hi) || y.hi == 0;
  if (may_be_below && may_be_above && x.lo <= 0) return Affine<B>(range);
  const AffineForm form = affine_detail::angle_form(y, x);
  return form.is_finite() ? affine_detail::with_units<B>(form, range, B::atan2_units) : Affine<B>(range);
}

/// As that of an Interval: in one piece around the seam, and maybe negative.
template <class B>
Affine<B> line_angle(const Vec2<Affine<B>>& point) {
  const auto [x, y] = std::pair(point.x, point.y);
  const Interval<B> range = line_angle(Vec2<Interval<B>>(x.range(), y.range()));
  const bool turned = y.hi < 0 || (!(y.lo > 0) && x.hi < 0), around_seam = !(y.lo > 0 || y.hi < 0);
  if (around_seam && !(x.lo > 0 || x.hi < 0)) return Affine<B>(range);
  const AffineForm form = turned ? affine_detail::angle_form(-y, -x) : affine_detail::angle_form(y, x);
  if (!form.is_finite()) return Affine<B>(range);
  const double rounding = around_seam ? 16 * B::atan2_units * (DoubleArithmetic::relative + B::relative) : 0;
  return Affine<B>(form, range, 2 * B::atan2_units * B::relative, 2 * B::atan2_units * B::absolute + rounding);
}

/// |a|, of the exact sum of squares. Our arithmetic of it makes fewer than five roundings.
template <class B>
Affine<B> length(const Vec3<Affine<B>>& a) {
  using namespace affine_detail;
  const Interval<B> range = length(ranges(a));
  const Affine<DoubleArithmetic> squared = exact_squared_length(a);
  if (!squared.form.is_finite() || range.is_point()) return Affine<B>(range);
  const AffineForm form = sqrt_curve({std::max(squared.lo, 0.0), squared.hi}).of(squared.form);
  return Affine<B>(form, range, (4 * B::relative + B::root_relative) * (1 + 0x1p-20), B::absolute);
}

/// a / |a|: one factor for all components, 1 / sqrt of the exact sum of squares. normalize() makes fewer than six
/// roundings of a component (math/elementary/cosine_power.h).
template <class B>
Vec3<Affine<B>> normalize(const Vec3<Affine<B>>& a) {
  using namespace affine_detail;
  const Vec3<Interval<B>> range = normalize(ranges(a));
  const Affine<DoubleArithmetic> squared = exact_squared_length(a);
  if (!squared.form.is_finite() || !(squared.lo > 0))
    return {Affine<B>(range.x), Affine<B>(range.y), Affine<B>(range.z)};
  const AffineForm reciprocal = reciprocal_root_curve({squared.lo, squared.hi}).of(squared.form);
  const double reach = reciprocal.radius();
  const auto component = [&](const Affine<B>& x, const Interval<B>& within) {
    if (within.is_point() || !reciprocal.is_finite()) return Affine<B>(within);
    return Affine<B>(product(x.form, x.reach(), reciprocal, reach), within,
                     (4 * B::relative + B::root_relative + B::quotient_relative) * (1 + 0x1p-20), 2 * B::absolute);
  };
  return {component(a.x, range.x), component(a.y, range.y), component(a.z, range.z)};
}

static_assert(Number<Affine<DoubleArithmetic>> && Number<Affine<FloatArithmetic>>);

} // namespace refraster::inline REFRASTER_KIT
