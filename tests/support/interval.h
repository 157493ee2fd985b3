#pragma once
// The least bounds type: everything a fragment function needs, and a witness that it needs nothing else. A point of the
// real line somewhere in [lo, hi]; every operation rounds outward, so that its result holds whatever the operation may
// give, exactly or in double arithmetic, for any points of its operands. Infinite ends mean that nothing is known on
// that side. Comparing gives a Certainty, and there is no way from that to bool: an `if` on a number does not compile.

#include "math/elementary.h"
#include "math/lookup.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <concepts>
#include <initializer_list>
#include <numbers>

namespace refraster {

enum class Certainty { no, unknown, yes };

constexpr Certainty operator&(Certainty a, Certainty b) {
  return std::min(a, b);
}
constexpr Certainty operator|(Certainty a, Certainty b) {
  return std::max(a, b);
}
constexpr Certainty operator!(Certainty a) {
  return a == Certainty::yes ? Certainty::no : a == Certainty::no ? Certainty::yes : Certainty::unknown;
}
/// Whether it may be so.
constexpr bool any(Certainty a) {
  return a != Certainty::no;
}
/// Only what is certain counts.
constexpr int count_lanes(Certainty a) {
  return a == Certainty::yes ? 1 : 0;
}

/// Some integer in [lo, hi].
struct IndexRange {
  std::int32_t lo = 0, hi = 0;
};

inline double step_down(double x) {
  return std::nextafter(x, -std::numeric_limits<double>::infinity());
}
inline double step_up(double x) {
  return std::nextafter(x, std::numeric_limits<double>::infinity());
}

class Interval {
public:
  double lo, hi;

  Interval() = default;
  template <class A>
    requires std::is_arithmetic_v<A>
  explicit(!std::same_as<A, double>) Interval(A x) : lo(static_cast<double>(x)), hi(static_cast<double>(x)) {}
  Interval(double low, double high) : lo(low), hi(high) { assert(low <= high); }

  static Interval anything() {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }

  bool contains(double x) const { return lo <= x && x <= hi; }
  double width() const { return hi - lo; }

  friend Interval operator-(Interval a) { return {-a.hi, -a.lo}; }
  friend Interval operator+(Interval a, Interval b) { return {rounded_sum(a.lo, b.lo).lo, rounded_sum(a.hi, b.hi).hi}; }
  friend Interval operator-(Interval a, Interval b) { return a + -b; }
  friend Interval operator*(Interval a, Interval b) {
    return hull({rounded_product(a.lo, b.lo), rounded_product(a.lo, b.hi), rounded_product(a.hi, b.lo),
                 rounded_product(a.hi, b.hi)});
  }
  friend Interval operator/(Interval a, Interval b) {
    if (b.contains(0)) return anything();
    return hull({rounded_quotient(a.lo, b.lo), rounded_quotient(a.lo, b.hi), rounded_quotient(a.hi, b.lo),
                 rounded_quotient(a.hi, b.hi)});
  }
  Interval& operator+=(Interval b) { return *this = *this + b; }
  Interval& operator-=(Interval b) { return *this = *this - b; }
  Interval& operator*=(Interval b) { return *this = *this * b; }
  Interval& operator/=(Interval b) { return *this = *this / b; }

  friend Certainty operator<(Interval a, Interval b) {
    return a.hi < b.lo ? Certainty::yes : a.lo >= b.hi ? Certainty::no : Certainty::unknown;
  }
  friend Certainty operator>(Interval a, Interval b) { return b < a; }
  friend Certainty operator<=(Interval a, Interval b) { return !(b < a); }
  friend Certainty operator>=(Interval a, Interval b) { return b <= a; }

  /// The least interval that holds all of them.
  static Interval hull(std::initializer_list<Interval> parts) {
    Interval all = *parts.begin();
    for (const Interval& part : parts) all = {std::min(all.lo, part.lo), std::max(all.hi, part.hi)};
    return all;
  }

private:
  // What x op y rounds to downward and upward. The rounding error of an operation has a known sign, by exact sums or by
  // fma; an exact result keeps width 0, so that a zero stays a zero.
  static Interval around(double rounded, double error) {
    if (std::isnan(error)) return {step_down(rounded), step_up(rounded)};
    return {error < 0 ? step_down(rounded) : rounded, error > 0 ? step_up(rounded) : rounded};
  }
  // An infinite end stands for numbers beyond any bound, and is exact; a finite result that overflows is not.
  static Interval rounded_sum(double x, double y) {
    const double sum = x + y;
    if (std::isnan(sum)) return anything();
    if (std::isinf(sum)) return std::isinf(x) || std::isinf(y) ? Interval{sum} : beyond_largest(sum);
    return around(sum, exact_sum(x, y).lo);
  }
  static Interval rounded_product(double x, double y) {
    if (x == 0 || y == 0) return {0.0};
    const double product = x * y;
    if (std::isinf(product)) return std::isinf(x) || std::isinf(y) ? Interval{product} : beyond_largest(product);
    if (std::abs(product) < 0x1p-960) return {step_down(product), step_up(product)}; // fma itself rounds down there
    return around(product, std::fma(x, y, -product));
  }
  static Interval rounded_quotient(double x, double y) {
    const double quotient = x / y;
    if (std::isnan(quotient)) return anything();
    if (std::isinf(quotient)) return std::isinf(x) ? Interval{quotient} : beyond_largest(quotient);
    if (std::isinf(y) || x == 0) return {0.0};
    if (std::abs(quotient) < 0x1p-960 || std::abs(x) < 0x1p-960) return {step_down(quotient), step_up(quotient)};
    const double remainder = std::fma(-quotient, y, x);
    return around(quotient, y > 0 ? remainder : -remainder);
  }
  static Interval beyond_largest(double infinity) {
    constexpr double largest = std::numeric_limits<double>::max();
    return infinity > 0 ? Interval{largest, infinity} : Interval{infinity, -largest};
  }

  friend Interval root(Interval x);
};

template <>
struct NumberTraits<Interval> {
  using Real = double; // tables are read in double
  using Mask = Certainty;
  using Index = IndexRange;
  static constexpr int lanes = 1;
};

inline Interval select(Certainty m, Interval x, Interval y) {
  return m == Certainty::yes ? x : m == Certainty::no ? y : Interval::hull({x, y});
}
inline Interval maximum(Interval x, Interval y) {
  return {std::max(x.lo, y.lo), std::max(x.hi, y.hi)};
}
inline Interval minimum(Interval x, Interval y) {
  return {std::min(x.lo, y.lo), std::min(x.hi, y.hi)};
}
inline Interval magnitude(Interval x) {
  const double a = std::abs(x.lo), b = std::abs(x.hi);
  return {x.contains(0) ? 0 : std::min(a, b), std::max(a, b)};
}
inline Interval square(Interval x) {
  const Interval size = magnitude(x);
  return size * size;
}
/// The square root of what is not negative in x; 0 where nothing is.
inline Interval root(Interval x) {
  const auto ends = [](double y) {
    const double r = std::sqrt(y);
    return std::isinf(y) || y == 0 ? Interval(r)
           : y < 0x1p-960          ? Interval(step_down(r), step_up(r))
                                   : Interval::around(r, std::fma(-r, r, y));
  };
  return {ends(std::max(x.lo, 0.0)).lo, ends(std::max(x.hi, 0.0)).hi};
}
inline Interval exact_reciprocal(Interval s) {
  return {exact_reciprocal(s.hi), exact_reciprocal(s.lo)};
} // s > 0
inline Interval reciprocal_binade(Interval x) {
  const Interval size = magnitude(x);
  return {reciprocal_binade(size.hi), reciprocal_binade(size.lo)};
}

inline Cell<Interval> cell(Interval x) {
  const Cell<double> low = cell(x.lo), high = cell(x.hi);
  const IndexRange index = {low.index, high.index};
  if (low.index != high.index) return {index, {0, 1}};
  return {index, {low.fraction, high.fraction}}; // exact: both ends minus the same integer
}
inline IndexRange clamp_index(IndexRange i, std::int32_t lo, std::int32_t hi) {
  return {clamp_index(i.lo, lo, hi), clamp_index(i.hi, lo, hi)};
}
inline IndexRange wrap_index(IndexRange i, std::int32_t n) {
  const std::int32_t low = wrap_index(i.lo, n), high = wrap_index(i.hi, n);
  const bool within_one_turn = std::int64_t{i.hi} - i.lo < n && low <= high;
  return within_one_turn ? IndexRange{low, high} : IndexRange{0, n - 1};
}
inline IndexRange next_index(IndexRange i) {
  return {i.lo + 1, i.hi + 1};
}

/// The hull of all table values in the ranges.
template <std::same_as<Interval> T, class Fetch>
Rgb<T> lookup(const Fetch& fetch, IndexRange i, IndexRange j, IndexRange k) {
  const auto at = [&](std::int32_t x, std::int32_t y, std::int32_t z) {
    const Rgb<double> value = fetch(x, y, z);
    return Rgb<T>(value.x, value.y, value.z);
  };
  Rgb<T> all = at(i.lo, j.lo, k.lo);
  for (std::int32_t x = i.lo; x <= i.hi; ++x)
    for (std::int32_t y = j.lo; y <= j.hi; ++y)
      for (std::int32_t z = k.lo; z <= k.hi; ++z) {
        const Rgb<T> value = at(x, y, z);
        all = {T::hull({all.x, value.x}), T::hull({all.y, value.y}), T::hull({all.z, value.z})};
      }
  return all;
}

/// The values f takes between its values at the ends of x, for a rising f that is computed with an error of `max_ulp`.
/// A computed value in between lies within max_ulp of an exact one, and that within max_ulp of the computed ends: that
/// is 2 max_ulp, and one step more because an ulp is half as wide below a power of two.
template <class Function>
Interval of_rising(const Function& f, Interval x, double max_ulp) {
  Interval ends = {f(x.lo), f(x.hi)};
  for (double ulp = 0; ulp < 2 * max_ulp + 1; ++ulp) ends = {step_down(ends.lo), step_up(ends.hi)};
  return ends;
}

/// Exact values below the one at which exp2 and power cut to 0 may be anything down to 0, and computed ones are 0.
inline Interval with_cut_off(Interval x) {
  const double cut = std::ldexp(1.0, static_cast<int>(lowest_power<double>)) * (1 + 0x1p-40);
  return {x.lo <= cut ? 0 : x.lo, std::max(x.hi, cut)};
}

inline Interval log2(Interval x) {
  const auto f = [](double y) { return log2(y); };
  return of_rising(f, x, log2_error<double>.max);
}
inline Interval exp2(Interval x) {
  const auto f = [](double y) { return exp2(y); };
  return with_cut_off(of_rising(f, x, exp2_error<double>.max));
}
/// Rising in x. Never above 1 for x <= 1, and exact for s = 0 and x = 0 or 1.
inline Interval power(Interval x, double s) {
  if (s == 0) return {1.0};
  if (x.hi <= 0) return {0.0};
  const auto f = [s](double y) { return power(y, s); };
  Interval result = with_cut_off(of_rising(f, x, power_error<double>.max));
  if (x.lo >= 1) result.lo = 1;
  if (x.hi <= 1) result.hi = std::min(result.hi, 1.0);
  return result;
}

/// As the plain function, for whatever vectors the boxes hold: near a = b by |a - b|^2 / 2, else by the dot product.
inline Interval cosine_power(const Vec3<Interval>& a, const Vec3<Interval>& b, double s) {
  if (s == 0) return {1.0};
  const Interval half_square = Interval(0.5) * squared_length(a - b), dotted = dot(a, b);
  const Interval cosine = select(dotted > Interval(0.5), Interval(1.0) - half_square, dotted); // as for double
  const Interval q = minimum(half_square, Interval(0.25));
  // Twice the error of small_power, as in of_rising.
  const auto plain = [s](const OnePlus<double>& base) {
    const double r = small_power(base, s);
    const double error = small_power_error_at_1 - small_power_error_per_bit * log2(r + smallest_result<double>);
    const double relative = error * std::numeric_limits<double>::epsilon();
    return Interval(std::max(r * (1 - relative), 0.0), std::min(r * (1 + relative), 1.0));
  };
  const Interval near = with_cut_off({plain({-q.hi, 0}).lo, plain({-q.lo, 0}).hi});
  const auto of_cosine = [&](double c) { return c > 0 ? plain(one_plus(std::min(c, 0.75))) : Interval(0.0); };
  const Interval far = with_cut_off({of_cosine(cosine.lo).lo, of_cosine(cosine.hi).hi});
  return select(cosine > Interval(0.75), near, far);
}

/// Extreme at corners of the box, if the angle does not jump in it.
inline Interval atan2(Interval y, Interval x) {
  constexpr double turn = std::numbers::pi;
  if (y.contains(0) && x.lo <= 0) return {step_down(-turn), step_up(turn)};
  const auto corner = [](double at_y, double at_x) {
    const auto f = [at_x](double v) { return atan2(v, at_x); };
    return of_rising(f, Interval(at_y), atan2_error<double>.max);
  };
  return Interval::hull({corner(y.lo, x.lo), corner(y.lo, x.hi), corner(y.hi, x.lo), corner(y.hi, x.hi)});
}

static_assert(Number<Interval>);
static_assert(!std::convertible_to<Certainty, bool> && !std::constructible_from<bool, Interval>);

} // namespace refraster
