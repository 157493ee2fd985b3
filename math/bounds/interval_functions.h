#pragma once
// What a Number has beside + - * /, for ranges: docs/number.md. Monotone functions are taken at the ends.

#include "math/bounds/interval.h"
#include "math/read_grid.h"

#include <array>
#include <numbers>

namespace refraster::inline REFRASTER_KIT {

template <class B>
Interval<B> join(Interval<B> x, Interval<B> y) {
  return Interval<B>::hull({x, y});
}
template <class B>
Rgb<Interval<B>> join(const Rgb<Interval<B>>& a, const Rgb<Interval<B>>& b) {
  return {join(a.x, b.x), join(a.y, b.y), join(a.z, b.z)};
}

template <class B>
Interval<B> select(Certainty m, Interval<B> x, Interval<B> y) {
  return m == Certainty::yes ? x : m == Certainty::no ? y : join(x, y);
}
template <class B>
Interval<B> max(Interval<B> x, Interval<B> y) {
  return {std::max(x.lo, y.lo), std::max(x.hi, y.hi)};
}
template <class B>
Interval<B> min(Interval<B> x, Interval<B> y) {
  return {std::min(x.lo, y.lo), std::min(x.hi, y.hi)};
}
template <class B>
Interval<B> abs(Interval<B> x) {
  const double a = std::abs(x.lo), b = std::abs(x.hi);
  return {x.contains(0) ? 0 : std::min(a, b), std::max(a, b)};
}
template <class B>
Interval<B> square(Interval<B> x) {
  const Interval<B> size = abs(x), squared = size * size;
  return {std::max(squared.lo, 0.0), squared.hi};
}
/// The square root of what is not negative in x; 0 where nothing is.
template <class B>
Interval<B> sqrt(Interval<B> x) {
  using namespace interval_detail;
  const auto ends = [](double y) {
    const double r = std::sqrt(y);
    return std::isinf(y) || y == 0 ? Interval<B>(r)
           : y < 0x1p-960          ? Interval<B>(step_down(r), step_up(r))
                                   : Interval<B>::around(r, std::fma(-r, r, y));
  };
  return Interval<B>::computed({ends(std::max(x.lo, 0.0)).lo, ends(std::max(x.hi, 0.0)).hi}, B::root_relative);
}

/// Within a cell: both ends less the same integer, which rounds just below 0.
template <class B>
Interval<B> fraction(Interval<B> x) {
  x = {std::clamp(x.lo, -cell_limit, cell_limit), std::clamp(x.hi, -cell_limit, cell_limit)};
  const Cell<double> low = floor_and_fraction(x.lo), high = floor_and_fraction(x.hi);
  if (low.index != high.index) return {0, 1};
  const Interval<B> rest = x - Interval<B>(low.index);
  return {std::clamp(rest.lo, 0.0, 1.0), std::clamp(rest.hi, 0.0, 1.0)};
}

namespace interval_detail {

/// The values of a rising function at the ends of a range, whose roundings may have exchanged them.
template <class B>
Interval<B> ordered(double a, double b) {
  return {std::min(a, b), std::max(a, b)};
}

/// The values of a rising f at the ends of x, with the error of f in double, in units of 2^-52 of the value, and then
/// that of the budget in its units.
template <class B, class Function>
Interval<B> of_rising(const Function& f, Interval<B> x, double double_units, double budget_units) {
  const double relative = 2 * (double_units * DoubleArithmetic::relative + budget_units * B::relative);
  // And the product of the two. Of a subnormal result the last place is worth 2 absolute, whatever its size.
  return ordered<B>(f(x.lo), f(x.hi)).widened(relative * (1 + 0x1p-20), 2 * std::max(budget_units, 1.0) * B::absolute);
}

/// Of exp2 in x.
template <class B>
double exp2_units(Interval<B> x) {
  if (B::exp2_units_by_exponent == 0) return B::exp2_units;
  return B::exp2_units + B::exp2_units_by_exponent * std::max(std::abs(x.lo), std::abs(x.hi));
}

/// What lies below the cut-off may be 0; and what double cuts off is more than the 0 it gives.
template <class B>
Interval<B> with_cut_off(Interval<B> x) {
  const auto cut = [](double exponent) { return std::ldexp(1 + 0x1p-20, static_cast<int>(exponent)); };
  return {x.lo <= cut(B::cut_off) ? 0 : x.lo, std::max(x.hi, cut(DoubleArithmetic::cut_off))};
}

} // namespace interval_detail

template <class B>
Interval<B> log2(Interval<B> x) {
  const auto f = [](double y) { return log2(y); };
  Interval<B> result = interval_detail::of_rising(f, x, DoubleArithmetic::log2_units, B::log2_units);
  if (const double more = B::log2_absolute; more > 0) { // the zero of 1 too
    using namespace interval_detail;
    result = {step_down(result.lo - more), step_up(result.hi + more)};
  }
  if (std::isinf(x.hi)) result.hi = x.hi;                             // where our own saturate
  if (B::powers == Powers::by_logarithm && x.lo < B::smallest_normal) // nor is that of 0 finite elsewhere
    result.lo = -std::numeric_limits<double>::infinity();
  // What is not positive counts as the smallest positive number, of any format from float on.
  constexpr double smallest_float = static_cast<double>(std::numeric_limits<float>::denorm_min());
  if (x.lo < smallest_float) result.hi = std::max(result.hi, log2(smallest_float));
  return result;
}
template <class B>
Interval<B> exp2(Interval<B> x) {
  using namespace interval_detail;
  const auto f = [](double y) { return exp2(y); };
  return with_cut_off(of_rising(f, x, DoubleArithmetic::exp2_units, exp2_units(x)));
}
/// Rising in x. Never above 1 for x <= 1, and exact for s = 0 and x = 0 or 1.
template <class B>
Interval<B> pow(Interval<B> x, double s) {
  using namespace interval_detail;
  if (s == 0) return {1.0};
  if (x.hi <= 0) return {0.0};
  if constexpr (B::powers == Powers::by_logarithm) return exp2(as<Interval<B>>(s) * log2(max(x, {0.0})));
  const auto f = [s](double y) { return pow(y, s); };
  Interval<B> result = with_cut_off(of_rising(f, x, DoubleArithmetic::pow_units, B::pow_units));
  if (std::isinf(x.hi)) result.hi = x.hi;
  if (x.lo >= 1) result.lo = std::max(result.lo, 1.0);
  if (x.hi <= 1) result.hi = std::min(result.hi, 1.0);
  return result;
}

/// a.b added up in any order, also fused: no product goes through more than three roundings, and each of five
/// operations may lose `absolute`.
template <class B>
  requires(B::sums == Sums::in_any_order)
Interval<B> dot(const Vec3<Interval<B>>& a, const Vec3<Interval<B>>& b) {
  using Real = Interval<DoubleArithmetic>;
  const auto real = [](Interval<B> x) -> Real { return {x.lo, x.hi}; };
  const auto size = [](const Real& x) { return std::max(std::abs(x.lo), std::abs(x.hi)); };
  const Real x = real(a.x) * real(b.x), y = real(a.y) * real(b.y), z = real(a.z) * real(b.z), exact = x + y + z;
  if (!std::isfinite(exact.width())) return Interval<B>::anything();
  const double r = B::relative;
  const double error =
      ((3 * r + 3 * r * r + r * r * r) * (size(x) + size(y) + size(z)) + 5 * B::absolute) * (1 + 0x1p-40);
  using namespace interval_detail;
  return Interval<B>(step_down(exact.lo - error), step_up(exact.hi + error)).widened(0, 0); // may be beyond the largest
}
template <class B>
  requires(B::sums == Sums::in_any_order)
Interval<B> squared_length(const Vec3<Interval<B>>& a) {
  const Interval<B> mixed = dot(a, a), sum = square(a.x) + square(a.y) + square(a.z);
  // Of what is not negative: three roundings of itself, in any order.
  const double r = B::relative,
               least = sum.lo - ((3 * r + 3 * r * r + r * r * r) * sum.lo + 5 * B::absolute) * (1 + 0x1p-40);
  return {std::max(interval_detail::step_down(least), 0.0), std::max(mixed.hi, 0.0)};
}

/// As the plain function, for whatever vectors the boxes hold: near a = b by |a - b|^2 / 2, else by the dot product.
template <class B>
Interval<B> cosine_power(const Vec3<Interval<B>>& a, const Vec3<Interval<B>>& b, double s) {
  using namespace interval_detail;
  using T = Interval<B>;
  if (s == 0) return {1.0};
  if constexpr (B::powers == Powers::by_logarithm) return pow(max(dot(a, b), T(0)), s);
  const T half_square = T(0.5) * squared_length(a - b), dotted = dot(a, b);
  T cosine = dotted;
  if constexpr (std::same_as<B, DoubleArithmetic>) cosine = select(dotted > T(0.5), T(1) - half_square, dotted);
  const T q = min(half_square, T(0.25));
  // The errors of small_power in double and in the budget's arithmetic; the exponent may be rounded to float, which is
  // within the error that each bit of the result brings.
  const auto plain = [s](const OnePlus<double>& base) {
    const double r = small_power(base, s);
    const double units = small_power_error_at_1 - small_power_error_per_bit * log2(r + smallest_result<double>);
    const double relative = units * (DoubleArithmetic::relative + B::relative) * (1 + 0x1p-20);
    return T(std::max(r * (1 - relative), 0.0), std::min(r * (1 + relative), 1.0));
  };
  const T near = with_cut_off<B>(ordered<B>(plain({-q.hi, 0}).lo, plain({-q.lo, 0}).hi));
  const auto of_cosine = [&](double c) { return c > 0 ? plain(one_plus(std::min(c, 0.75))) : T(0.0); };
  const double low = cosine.lo < B::smallest_normal ? 0 : cosine.lo; // counts as 0, or may
  const T far = with_cut_off<B>(ordered<B>(of_cosine(low).lo, of_cosine(cosine.hi).hi));
  return select(cosine > T(0.75), near, far);
}

/// Extreme at corners of the box, if the angle does not jump in it. Bounds know the sign of a zero only where it was
/// given: y as it comes from sqrt or abs, which have none below.
template <class B>
Interval<B> atan2(Interval<B> y, Interval<B> x) {
  const bool may_be_below = std::signbit(y.lo), may_be_above = !std::signbit(y.hi) || y.hi == 0;
  if (may_be_below && may_be_above && x.lo <= 0) {
    const Interval<B> pi = NumberTraits<Interval<B>>::constant(constants::pi);
    // Ours is never beyond pi.
    const double most =
        B::atan2_units > DoubleArithmetic::atan2_units ? pi.widened(2 * B::atan2_units * B::relative).hi : pi.hi;
    return {-most, most};
  }
  const auto corner = [](double at_y, double at_x) {
    const auto f = [at_x](double v) { return atan2(v, at_x); };
    using namespace interval_detail;
    const Interval<B> angle = of_rising(f, Interval<B>(at_y), DoubleArithmetic::atan2_units, B::atan2_units);
    return at_y != 0 && f(at_y) == 0 ? Interval<B>(step_down(0), step_up(0)) : angle; // it underflowed
  };
  return Interval<B>::hull({corner(y.lo, x.lo), corner(y.lo, x.hi), corner(y.hi, x.lo), corner(y.hi, x.hi)});
}

/// The direction of the line through 0 and a point: where other numbers turn it into [0, pi), it stays in one piece
/// around the seam, and may be negative. Who reads a grid by it repeats that axis.
template <class B>
Interval<B> line_angle(const Vec2<Interval<B>>& point) {
  const auto [x, y] = std::pair(point.x, point.y);
  if (y.lo > 0) return atan2(y, x);
  if (y.hi < 0) return atan2(-y, -x);
  // Other numbers may have it just below pi, and round it, and what they make of it, as much as pi: the error of an
  // angle of pi in units of 2 r is below 7 r a unit, and 9 r a unit is as much as six roundings of pi, in ours.
  const auto around_seam = [](Interval<B> angle) -> Interval<B> {
    const double rounding = 16 * B::atan2_units * (DoubleArithmetic::relative + B::relative);
    return {angle.lo - rounding, angle.hi + rounding};
  };
  if (x.lo > 0) return around_seam(atan2(y, x));
  if (x.hi < 0) return around_seam(atan2(-y, -x));
  return {0, NumberTraits<Interval<B>>::constant(constants::pi).hi};
}

/// |a|: it grows with the size of each component. Our arithmetic of it makes fewer than five roundings.
template <class B>
Interval<B> length(const Vec3<Interval<B>>& a) {
  const Interval<B> x = abs(a.x), y = abs(a.y), z = abs(a.z);
  const Interval<B> ends =
      interval_detail::ordered<B>(length(Double3(x.lo, y.lo, z.lo)), length(Double3(x.hi, y.hi, z.hi)));
  return ends.widened((5 * DoubleArithmetic::relative + 4 * B::relative + B::root_relative) * (1 + 0x1p-20));
}

/// a / |a|, component by component: x / sqrt(x^2 + r^2) rises with x, and its size falls with r, the length of the
/// other two. normalize() makes fewer than six roundings of a component (math/elementary/cosine_power.h).
template <class B>
Vec3<Interval<B>> normalize(const Vec3<Interval<B>>& a) {
  const double relative =
      (6 * DoubleArithmetic::relative + 4 * B::relative + B::root_relative + B::quotient_relative) * (1 + 0x1p-20);
  const auto component = [relative](Interval<B> x, Interval<B> y, Interval<B> z) -> Interval<B> {
    y = abs(y), z = abs(z);
    const auto least = [&](double at) { // the lowest value for this x
      const Double3 across = at < 0 ? Double3(0, y.lo, z.lo) : Double3(0, y.hi, z.hi);
      if (at == 0) return 0.0;
      if (std::isinf(at)) return at < 0 ? -1.0 : 0.0;
      if (std::isinf(across.y) || std::isinf(across.z)) return 0.0;
      const double x_of_unit = normalize(Double3(at, across.y, across.z)).x;
      return x_of_unit == 0 ? interval_detail::step_down(0.0) : x_of_unit;
    };
    const Interval<B> ends = interval_detail::ordered<B>(least(x.lo), -least(-x.hi));
    const Interval<B> rounded = ends.widened(relative, 2 * B::absolute);
    return {std::max(rounded.lo, -1 - relative), std::min(rounded.hi, 1 + relative)};
  };
  return {component(a.x, a.y, a.z), component(a.y, a.z, a.x), component(a.z, a.x, a.y)};
}

namespace interval_detail {

/// The cells of one axis that a place may lie in.
struct CellRange {
  std::int32_t first, last;
};

template <class B>
CellRange cells_of(Interval<B>& place, const GridAxis& axis) {
  if (axis.beyond == GridAxis::Beyond::repeated) {
    if (!(place.hi - place.lo < axis.count)) place = {0, static_cast<double>(axis.count)};
    else place = {std::clamp(place.lo, -cell_limit, cell_limit), std::clamp(place.hi, -cell_limit, cell_limit)};
  } else {
    // All interpolation is between at most four samples: farther out than that nothing changes any more.
    constexpr double margin = 4;
    place = {std::clamp(place.lo, -margin, axis.count + margin), std::clamp(place.hi, -margin, axis.count + margin)};
  }
  return {floor_and_fraction(place.lo).index, floor_and_fraction(place.hi).index};
}

} // namespace interval_detail

/// x, of which it is known that it lies in `range`.
template <class B>
Interval<B> with_range(const Interval<B>&, const Interval<B>& range) {
  return range;
}
/// Where x is in a cell: [0, 1] less what of it is outside of the range.
template <class B>
Interval<B> within_cell(const Interval<B>& x, std::int32_t index) {
  const Interval<B> rest = x - Interval<B>(index);
  return {std::clamp(rest.lo, 0.0, 1.0), std::clamp(rest.hi, 0.0, 1.0)};
}

/// The cells that a place may lie in, one after the other, each with the part of the place that lies there.
template <class T, std::size_t dimensions>
class CellWalk {
public:
  using Cells = std::array<Cell<T>, dimensions>;

  /// range(x) is the Interval of a coordinate.
  template <class Range>
  CellWalk(const std::array<T, dimensions>& place, const std::array<GridAxis, dimensions>& axes, const Range& range)
      : inside_(place) {
    for (std::size_t d = 0; d < dimensions; ++d) {
      auto bounded = range(place[d]);
      const auto whole = bounded;
      range_[d] = interval_detail::cells_of(bounded, axes[d]);
      if (bounded.lo != whole.lo || bounded.hi != whole.hi) inside_[d] = with_range(place[d], bounded);
    }
    start();
  }

  std::int64_t count() const {
    std::int64_t count = 1;
    for (const auto& [first, last] : range_) count *= std::int64_t{last} - first + 1;
    return count;
  }
  /// To the first cell.
  void start() {
    for (std::size_t d = 0; d < dimensions; ++d) enter(d, range_[d].first);
  }
  /// To the next; false, and to the first, after the last.
  bool next() {
    std::size_t d = 0;
    while (d < dimensions && cells_[d].index == range_[d].last) enter(d, range_[d].first), ++d;
    if (d == dimensions) return false;
    enter(d, cells_[d].index + 1);
    return true;
  }
  const Cells& cells() const { return cells_; }

private:
  void enter(std::size_t d, std::int32_t index) { cells_[d] = {index, within_cell(inside_[d], index)}; }

  std::array<interval_detail::CellRange, dimensions> range_;
  std::array<T, dimensions> inside_;
  Cells cells_;
};

/// See read_grid. Every cell is read, however many there are.
template <class B, std::size_t dimensions, class Read>
auto read_every_cell(const std::array<Interval<B>, dimensions>& place, const std::array<GridAxis, dimensions>& axes,
                     const Read& read) {
  CellWalk<Interval<B>, dimensions> walk(place, axes, [](const Interval<B>& x) { return x; });
  auto value = read(walk.cells());
  while (walk.next()) value = join(value, read(walk.cells()));
  return value;
}

static_assert(Number<Interval<DoubleArithmetic>> && Number<Interval<FloatArithmetic>>);
static_assert(!std::convertible_to<Certainty, bool> && !std::constructible_from<bool, Certainty>);

} // namespace refraster::inline REFRASTER_KIT
