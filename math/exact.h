#pragma once
// A number of 60 digits: the truth that every precision is judged by.

#include "math/constants.h"
#include "math/vec.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>

namespace refraster::inline REFRASTER_KIT {

/// Makes the limits of a Boost number that its functions look up. Boost 1.74 makes each at its first use, by a flag that
/// is set before the value is there, and before main only those of the number without the other kind of expressions, which
/// eval_log and its kin do not ask for. Two threads whose first logarithm is at the same time would read an epsilon of 0,
/// or of 1: a series that does not end, or one that ends after a term.
template <class Backend>
bool make_limits() {
  namespace mp = boost::multiprecision;
  const auto make = []<class Number>(Number) {
    using Limits = std::numeric_limits<Number>;
    static_cast<void>((Limits::min)()), static_cast<void>((Limits::max)());
    static_cast<void>(Limits::epsilon()), static_cast<void>(Limits::round_error());
    static_cast<void>(Limits::infinity()), static_cast<void>(Limits::quiet_NaN());
  };
  make(mp::number<Backend, mp::et_on>());
  make(mp::number<Backend, mp::et_off>());
  return true;
}

/// 60 decimal digits, four times those of double, so that what cancels leaves enough; exponents beyond any that a
/// formula meets. Nothing is cut off or saturated as the formats of IEEE 754 have it. Boost's cpp_bin_float, in a type
/// of this namespace, so that the names of math/number.h find it.
class Exact {
public:
  using Value = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<60>, boost::multiprecision::et_off>;

  Exact() = default;
  template <class A>
    requires std::is_arithmetic_v<A>
  explicit(!std::same_as<A, double>) Exact(A x) : value_(x) {}
  explicit Exact(Value value) : value_(std::move(value)) {}

  const Value& value() const { return value_; }
  explicit operator double() const { return static_cast<double>(value_); }

  friend Exact operator+(const Exact& a, const Exact& b) { return Exact(Value(a.value_ + b.value_)); }
  friend Exact operator-(const Exact& a, const Exact& b) { return Exact(Value(a.value_ - b.value_)); }
  friend Exact operator*(const Exact& a, const Exact& b) { return Exact(Value(a.value_ * b.value_)); }
  friend Exact operator/(const Exact& a, const Exact& b) { return Exact(Value(a.value_ / b.value_)); }
  friend Exact operator-(const Exact& a) { return Exact(Value(-a.value_)); }
  Exact& operator+=(const Exact& b) { return *this = *this + b; }
  Exact& operator-=(const Exact& b) { return *this = *this - b; }
  Exact& operator*=(const Exact& b) { return *this = *this * b; }
  Exact& operator/=(const Exact& b) { return *this = *this / b; }

  friend bool operator<(const Exact& a, const Exact& b) { return a.value_ < b.value_; }
  friend bool operator>(const Exact& a, const Exact& b) { return a.value_ > b.value_; }
  friend bool operator<=(const Exact& a, const Exact& b) { return a.value_ <= b.value_; }
  friend bool operator>=(const Exact& a, const Exact& b) { return a.value_ >= b.value_; }
  friend bool operator==(const Exact& a, const Exact& b) { return a.value_ == b.value_; }

private:
  Value value_;
};

/// Before main, or when a library that renders is loaded: before there are threads that render.
inline const bool exact_limits_are_made = make_limits<Exact::Value::backend_type>();

template <>
struct NumberTraits<Exact> {
  using Real = double;
  using Mask = bool;
  using Index = std::int32_t;
  static constexpr int lanes = 1;
  static constexpr bool has_lanes = false, decides = true, is_ieee = false;
  static constexpr double largest = std::numeric_limits<double>::max(); // what leaves a formula becomes a double

  static Exact constant(const RealConstant& c) { return Exact(Exact::Value(c.digits)); }
};

inline Exact select(bool m, const Exact& x, const Exact& y) {
  return m ? x : y;
}
inline Exact max(const Exact& x, const Exact& y) {
  return x > y ? x : y;
}
inline Exact min(const Exact& x, const Exact& y) {
  return x < y ? x : y;
}
inline Exact abs(const Exact& x) {
  return x < Exact(0) ? -x : x;
}
inline Exact square(const Exact& x) {
  return x * x;
}
/// 0 below 0.
inline Exact sqrt(const Exact& x) {
  return x > Exact(0) ? Exact(Exact::Value(sqrt(x.value()))) : Exact(0);
}
inline Cell<Exact> floor_and_fraction(const Exact& x) {
  const Exact inside = min(max(x, Exact(-cell_limit)), Exact(cell_limit));
  const Exact::Value below = floor(inside.value());
  return {static_cast<std::int32_t>(below), inside - Exact(below)};
}
inline Exact fraction(const Exact& x) {
  return floor_and_fraction(x).fraction;
}

/// log2(x); of what is not positive, that of the smallest positive double, as of every precision.
inline Exact log2(const Exact& x) {
  using boost::multiprecision::log2;
  return Exact(Exact::Value(log2(max(x, Exact(std::numeric_limits<double>::denorm_min())).value())));
}
/// 2^x, for |x| up to 2^20; beyond, as there.
inline Exact exp2(const Exact& x) {
  const Exact inside = min(max(x, Exact(-0x1p20)), Exact(0x1p20));
  return Exact(Exact::Value(pow(Exact::Value(2), inside.value())));
}
/// x^s for s >= 0; x^0 = 1, also for x = 0; x < 0 counts as 0.
inline Exact pow(const Exact& x, double s) {
  if (s == 0) return Exact(1);
  return x > Exact(0) ? Exact(Exact::Value(pow(x.value(), Exact::Value(s)))) : Exact(0);
}
/// In (-pi, pi]; atan2(0, 0) = 0.
inline Exact atan2(const Exact& y, const Exact& x) {
  using boost::multiprecision::atan2;
  if (x == Exact(0) && y == Exact(0)) return Exact(0);
  return Exact(Exact::Value(atan2(y.value(), x.value())));
}
/// max(cos, 0)^s of the angle between two vectors, whose lengths may be those of unit vectors as they were rounded.
inline Exact cosine_power(const Vec3<Exact>& a, const Vec3<Exact>& b, double s) {
  if (s == 0) return Exact(1);
  const Exact lengths = squared_length(a) * squared_length(b);
  return lengths > Exact(0) ? pow(dot(a, b) / sqrt(lengths), s) : Exact(0);
}

} // namespace refraster::inline REFRASTER_KIT
