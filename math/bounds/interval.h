#pragma once
// The simplest bounds number: a range that holds whatever a formula may give, exactly or in the arithmetic of a
// rounding budget, for any points of its operands. Moore, "Interval Analysis", 1966.

#include "math/bounds/certainty.h"
#include "math/bounds/rounding_budget.h"
#include "math/bounds/texture_errors.h"
#include "math/constants.h"
#include "math/vec.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <concepts>
#include <initializer_list>

namespace refraster::inline REFRASTER_KIT {

namespace interval_detail {
/// The next double above x, as std::nextafter has it, without a call.
inline double step_up(double x) {
  if (!(x < std::numeric_limits<double>::infinity())) return x;
  if (x == 0) return std::numeric_limits<double>::denorm_min();
  return std::bit_cast<double>(std::bit_cast<std::int64_t>(x) + (x > 0 ? 1 : -1));
}
inline double step_down(double x) {
  return -step_up(-x);
}
} // namespace interval_detail

/// [lo, hi], ends included; infinite ends mean that nothing is known on that side. Its own arithmetic rounds outward,
/// and then the budget of the operation is added: so the result holds the exact one and the computed one. A result that
/// is exact in every format (a sum with 0, a product with 0 or a power of two, a zero) gets no relative budget.
template <class Budget>
class Interval {
public:
  double lo = 0, hi = 0;

  Interval() = default;
  /// A number that every format holds, such as 0, 1/2 or 255. Parameters enter by as<T>().
  template <class A>
    requires std::is_arithmetic_v<A>
  explicit(!std::same_as<A, double>) Interval(A x) : lo(static_cast<double>(x)), hi(static_cast<double>(x)) {}
  Interval(double low, double high) : lo(low), hi(high) { assert(low <= high); }

  static Interval anything() {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }

  bool contains(double x) const { return lo <= x && x <= hi; }
  double width() const { return hi - lo; }
  bool is_point() const { return lo == hi; }

  friend Interval operator-(Interval a) { return {-a.hi, -a.lo}; }
  friend Interval operator+(Interval a, Interval b) {
    if (a.is_zero()) return b;
    if (b.is_zero()) return a;
    return computed({outward_sum(a.lo, b.lo).lo, outward_sum(a.hi, b.hi).hi});
  }
  friend Interval operator-(Interval a, Interval b) { return a + -b; }
  friend Interval operator*(Interval a, Interval b) {
    const Interval product = hull({outward_product(a.lo, b.lo), outward_product(a.lo, b.hi),
                                   outward_product(a.hi, b.lo), outward_product(a.hi, b.hi)});
    return a.is_power_of_two() || b.is_power_of_two() ? computed(product, 0) : computed(product);
  }
  friend Interval operator/(Interval a, Interval b) {
    if (b.contains(0)) return anything();
    const Interval quotient = hull({outward_quotient(a.lo, b.lo), outward_quotient(a.lo, b.hi),
                                    outward_quotient(a.hi, b.lo), outward_quotient(a.hi, b.hi)});
    return b.is_power_of_two() ? computed(quotient, 0) : computed(quotient, Budget::quotient_relative);
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

  /// With an error of at most relative |x| + absolute at each x but 0, which every format holds. What is beyond
  /// the largest number may be that number, or infinite.
  Interval widened(double relative, double absolute = Budget::absolute) const {
    const auto lower = [relative, absolute](double x) {
      if (x == 0 || std::isinf(x)) return std::min(x, Budget::largest);
      const double error = (std::abs(x) * relative + absolute) * (1 + 0x1p-50); // more than its own roundings
      const double moved = interval_detail::step_down(x - error);
      return moved < -Budget::largest ? -std::numeric_limits<double>::infinity() : std::min(moved, Budget::largest);
    };
    return {lower(lo), -lower(-hi)};
  }

  /// What an operation with this exact result may have computed. Rounding outward in double is all that double needs.
  static Interval computed(Interval exact, double relative = Budget::relative) {
    if constexpr (std::same_as<Budget, DoubleArithmetic>) return exact;
    else return exact.widened(relative);
  }

  /// From x as it is after rounding and the sign of its error, to an interval of one or two neighbours.
  static Interval around(double rounded, double error) {
    using namespace interval_detail;
    if (std::isnan(error)) return {step_down(rounded), step_up(rounded)};
    return {error < 0 ? step_down(rounded) : rounded, error > 0 ? step_up(rounded) : rounded};
  }

private:
  bool is_zero() const { return lo == 0 && hi == 0; }
  bool is_power_of_two() const {
    int exponent = 0;
    return is_point() && std::isfinite(lo) && std::abs(std::frexp(lo, &exponent)) == 0.5;
  }

  // What x op y rounds to downward and upward. The rounding error of an operation has a known sign, by exact sums or by
  // fma; an exact result keeps width 0, so that a zero stays a zero.
  // An infinite end stands for numbers beyond any bound, and is exact; a finite result that overflows is not.
  static Interval outward_sum(double x, double y) {
    const double sum = x + y;
    if (std::isnan(sum)) return anything();
    if (std::isinf(sum)) return std::isinf(x) || std::isinf(y) ? Interval{sum} : beyond_largest(sum);
    return around(sum, two_sum(x, y).lo);
  }
  static Interval outward_product(double x, double y) {
    using namespace interval_detail;
    if (x == 0 || y == 0) return {0.0};
    const double product = x * y;
    if (std::isinf(product)) return std::isinf(x) || std::isinf(y) ? Interval{product} : beyond_largest(product);
    if (std::abs(product) < 0x1p-960) return {step_down(product), step_up(product)}; // fma itself rounds down there
    return around(product, std::fma(x, y, -product));
  }
  static Interval outward_quotient(double x, double y) {
    using namespace interval_detail;
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
};

/// What every bounds number of a rounding budget says of itself.
template <class Budget>
struct BoundsTraits {
  using Real = double;
  using Mask = Certainty;
  using Index = std::int32_t; // of one cell: read_grid
  static constexpr int lanes = 1;
  static constexpr bool has_lanes = false, decides = false, is_ieee = false;
  static constexpr double largest = Budget::largest;
  /// How the device reads textures.
  /// Of a product or a sum of a device, relative.
  static double device_rounding() requires requires { Budget::texture(); }
  { return Budget::relative; }
  static const TextureErrors& texture_errors() requires requires { Budget::texture(); }
  { return Budget::texture(); }
};

template <class Budget>
struct NumberTraits<Interval<Budget>> : BoundsTraits<Budget> {
  /// A parameter as it is, and as the device may have rounded it. A number of single precision every device has.
  static Interval<Budget> parameter(double x) {
    if (std::isnan(x)) return Interval<Budget>::anything();
    const bool is_single = static_cast<double>(static_cast<float>(x)) == x;
    return is_single ? Interval<Budget>(x) : Interval<Budget>::computed(Interval<Budget>(x));
  }
  /// From that of double to that of the arithmetic.
  static Interval<Budget> smallest_normal() { return {DoubleArithmetic::smallest_normal, Budget::smallest_normal}; }
  static Interval<Budget> constant(const RealConstant& c) {
    using namespace interval_detail;
    return Interval<Budget>::computed({step_down(c.nearest), step_up(c.nearest)});
  }
};

} // namespace refraster::inline REFRASTER_KIT
