#pragma once
// A device of the worst kind that a rounding budget allows: the adversary of bounds.

#include "tests/support/random.h"

#include "math/bounds/rounding_budget.h"
#include "math/constants.h"
#include "math/read_grid.h"

namespace refraster {

/// A number of which each operation errs by as much as Budget allows, up or down as a generator says, or not at all:
/// flips() is to be seeded before a formula is run, so that the same seed makes the same errors.
template <class Budget>
class Perturbed {
public:
  Perturbed() = default;
  template <class A>
    requires std::is_arithmetic_v<A>
  explicit(!std::same_as<A, double>) Perturbed(A x) : value(static_cast<double>(x)) {}
  explicit operator double() const { return value; }

  static Random& flips() {
    static thread_local Random random(0);
    return random;
  }
  /// Of an exact result. A little less than all of it: double rounds too.
  static Perturbed of(double exact, double relative = Budget::relative) {
    constexpr double most = 1 - 0x1p-10;
    if (std::abs(exact) <= Budget::absolute && flips().below(2)) return Perturbed(0.0); // a denormal may be flushed
    return Perturbed(exact + exact * relative * most * (flips().below(3) - 1));
  }

  // What every format has exactly is not perturbed.
  friend Perturbed operator+(Perturbed a, Perturbed b) {
    return a.value == 0 ? b : b.value == 0 ? a : of(a.value + b.value);
  }
  friend Perturbed operator-(Perturbed a, Perturbed b) { return a + -b; }
  friend Perturbed operator*(Perturbed a, Perturbed b) {
    return is_power_of_two(a) || is_power_of_two(b) ? Perturbed(a.value * b.value) : of(a.value * b.value);
  }
  friend Perturbed operator/(Perturbed a, Perturbed b) {
    return is_power_of_two(b) ? Perturbed(a.value / b.value) : of(a.value / b.value, Budget::quotient_relative);
  }
  friend Perturbed operator-(Perturbed a) { return Perturbed(-a.value); }
  Perturbed& operator+=(Perturbed b) { return *this = *this + b; }
  Perturbed& operator-=(Perturbed b) { return *this = *this - b; }
  Perturbed& operator*=(Perturbed b) { return *this = *this * b; }
  Perturbed& operator/=(Perturbed b) { return *this = *this / b; }
  friend bool operator<(Perturbed a, Perturbed b) { return a.value < b.value; }
  friend bool operator>(Perturbed a, Perturbed b) { return a.value > b.value; }
  friend bool operator<=(Perturbed a, Perturbed b) { return a.value <= b.value; }
  friend bool operator>=(Perturbed a, Perturbed b) { return a.value >= b.value; }

  double value = 0;

private:
  static bool is_power_of_two(Perturbed x) {
    int exponent = 0;
    return std::abs(std::frexp(x.value, &exponent)) == 0.5;
  }
};

template <class B>
struct NumberTraits<Perturbed<B>> {
  using Real = double;
  using Mask = bool;
  using Index = std::int32_t;
  static constexpr int lanes = 1;
  static constexpr bool has_lanes = false, decides = true, is_ieee = false;
  static constexpr double largest = B::largest;

  static Perturbed<B> parameter(double x) {
    return Perturbed<B>(Perturbed<B>::flips().below(2) ? x : static_cast<double>(static_cast<float>(x)));
  }
};

template <class B>
Perturbed<B> select(bool m, Perturbed<B> x, Perturbed<B> y) {
  return m ? x : y;
}
template <class B>
Perturbed<B> max(Perturbed<B> x, Perturbed<B> y) {
  return x > y ? x : y;
}
template <class B>
Perturbed<B> min(Perturbed<B> x, Perturbed<B> y) {
  return x < y ? x : y;
}
template <class B>
Perturbed<B> abs(Perturbed<B> x) {
  return Perturbed<B>(abs(x.value));
}
template <class B>
Perturbed<B> square(Perturbed<B> x) {
  return x * x;
}
template <class B>
Perturbed<B> sqrt(Perturbed<B> x) {
  return Perturbed<B>::of(sqrt(max(x.value, 0.0)), B::root_relative);
}
template <class B>
Cell<Perturbed<B>> floor_and_fraction(Perturbed<B> x) {
  const Cell<double> cell = floor_and_fraction(x.value);
  return {cell.index, Perturbed<B>(cell.fraction)};
}
template <class B>
Perturbed<B> fraction(Perturbed<B> x) {
  return floor_and_fraction(x).fraction;
}
template <class B>
Perturbed<B> exp2(Perturbed<B> x) {
  return Perturbed<B>::of(exp2(x.value),
                          2 * (B::exp2_units + B::exp2_units_by_exponent * std::abs(x.value)) * B::relative);
}
template <class B>
Perturbed<B> log2(Perturbed<B> x) {
  const double less_or_more = B::log2_absolute * (Perturbed<B>::flips().below(3) - 1);
  return Perturbed<B>(Perturbed<B>::of(log2(x.value), 2 * B::log2_units * B::relative).value + less_or_more);
}
template <class B>
Perturbed<B> pow(Perturbed<B> x, double s) {
  if (s == 0) return Perturbed<B>(1);
  if constexpr (B::powers == Powers::by_logarithm)
    return x.value > 0 ? exp2(as<Perturbed<B>>(s) * log2(x)) : Perturbed<B>(0);
  return Perturbed<B>(min(Perturbed<B>::of(pow(x.value, s), 2 * B::pow_units * B::relative).value,
                          x.value <= 1 ? 1.0 : std::numeric_limits<double>::infinity()));
}
template <class B>
Perturbed<B> atan2(Perturbed<B> y, Perturbed<B> x) {
  return Perturbed<B>::of(atan2(y.value, x.value), 2 * B::atan2_units * B::relative);
}
/// Added up in some order, fused or not.
template <class B>
  requires(B::sums == Sums::in_any_order)
Perturbed<B> dot(const Vec3<Perturbed<B>>& a, const Vec3<Perturbed<B>>& b) {
  using T = Perturbed<B>;
  const int first = T::flips().below(3), second = (first + 1 + T::flips().below(2)) % 3, third = 3 - first - second;
  const auto plus = [](T sum, T x, T y) {
    return T::flips().below(2) ? sum + x * y : T::of(sum.value + x.value * y.value);
  };
  return plus(plus(a[first] * b[first], a[second], b[second]), a[third], b[third]);
}
template <class B>
  requires(B::sums == Sums::in_any_order)
Perturbed<B> squared_length(const Vec3<Perturbed<B>>& a) {
  return dot(a, a);
}
/// By the formula of the plain function, whose last step may lose what small_power loses.
template <class B>
Perturbed<B> cosine_power(const Vec3<Perturbed<B>>& a, const Vec3<Perturbed<B>>& b, double s) {
  if (s == 0) return Perturbed<B>(1);
  if constexpr (B::powers == Powers::by_logarithm) return pow(max(dot(a, b), Perturbed<B>(0)), s);
  const Perturbed<B> half_square = Perturbed<B>(0.5) * squared_length(a - b);
  const double cosine = dot(a, b).value, q = std::min(half_square.value, 0.25);
  const double r = cosine > 0.75 ? std::exp(s * std::log1p(-q)) : cosine < B::smallest_normal ? 0 : std::pow(cosine, s);
  const double units = small_power_error_at_1 - small_power_error_per_bit * std::log2(std::max(r, 0x1p-100));
  return Perturbed<B>(std::min(Perturbed<B>::of(r, units * B::relative).value, 1.0));
}

static_assert(Number<Perturbed<FloatArithmetic>>);

} // namespace refraster
