#pragma once
// Affine numbers with known points in them, and how tight what was computed from them is.

#include "tests/support/random.h"

#include "math/bounds/affine_functions.h"
#include "math/exact.h"

#include <utility>

namespace refraster {

/// The symbols of a trial, each somewhere in [-1, 1], often at an end.
using Symbols = std::array<double, AffineForm::symbols>;
inline Symbols some_symbols(Random& random) {
  Symbols e;
  for (double& x : e) x = random.below(2) ? random.sign() : random.uniform(-1, 1);
  return e;
}

/// centre + sum of slope[k] e_k: a number that is known where the symbols are.
struct Linear {
  double centre = 0;
  std::array<double, AffineForm::symbols> slope{};

  double at(const Symbols& e) const {
    double sum = centre;
    for (std::size_t k = 0; k < slope.size(); ++k) sum += slope[k] * e[k];
    return sum;
  }
  /// With what at() may round: 24 operations, each of at most 2^-53 of the largest sum; and what rounding the result
  /// to the arithmetic's format may add.
  template <class B>
  Affine<B> bounds() const {
    AffineForm form{centre, slope, 0};
    form.rest = (std::abs(centre) + form.radius()) * (0x1p-48 + B::relative * (1 + 0x1p-20));
    const double radius = form.radius();
    return Affine<B>::exactly(form,
                              {interval_detail::step_down(centre - radius), interval_detail::step_up(centre + radius)});
  }
};

/// Around a centre of [lo, hi] and by up to `reach` away from it; of the first `symbols` symbols.
inline Linear some_linear(Random& random, double lo, double hi, double reach, int symbols) {
  Linear line;
  line.centre = random.uniform(lo, hi);
  for (int k = 0; k < symbols; ++k) line.slope[static_cast<std::size_t>(k)] = random.uniform(-reach, reach) / symbols;
  return line;
}

/// Every operation of one and two numbers, by its name: check(name, operation). `s` is an exponent.
template <class Check>
void for_each_operation(double s, const Check& check) {
  check("+", [](const auto& x, const auto& y) { return x + y; });
  check("-", [](const auto& x, const auto& y) { return x - y; });
  check("*", [](const auto& x, const auto& y) { return x * y; });
  check("/", [](const auto& x, const auto& y) { return x / y; });
  check("minus", [](const auto& x, const auto&) { return -x; });
  check("max", [](const auto& x, const auto& y) { return max(x, y); });
  check("min", [](const auto& x, const auto& y) { return min(x, y); });
  check("abs", [](const auto& x, const auto&) { return abs(x); });
  check("square", [](const auto& x, const auto&) { return square(x); });
  check("sqrt", [](const auto& x, const auto&) { return sqrt(abs(x)); });
  check("fraction", [](const auto& x, const auto&) { return fraction(x); });
  check("log2", [](const auto& x, const auto&) { return log2(abs(x)); });
  check("exp2", [](const auto& x, const auto&) { return exp2(x); });
  check("pow", [s](const auto& x, const auto&) { return pow(x, s); });
  check("atan2", [](const auto& x, const auto& y) { return atan2(x, y); });
  check("atan2 of abs", [](const auto& x, const auto& y) { return atan2(abs(x), y); });
  check("select", [](const auto& x, const auto& y) { return select(x < y, x * y, x + y); });
}

template <class T>
double as_double(const T& x) {
  return static_cast<double>(x);
}

/// Whether bounds hold what was computed; NaN comes only of what is not finite.
template <class B>
bool holds(const Affine<B>& bounds, double value) {
  return std::isnan(value) || bounds.contains(value);
}

/// And whether the form alone does, with the symbols where they are: not only their hull.
template <class B>
bool form_holds(const Affine<B>& bounds, const Symbols& e, double value) {
  if (!std::isfinite(value) || !bounds.form.is_finite()) return true;
  Exact at(bounds.form.centre);
  for (std::size_t k = 0; k < e.size(); ++k) at += Exact(bounds.form.slope[k]) * Exact(e[k]);
  return abs(Exact(value) - at) <= Exact(bounds.form.rest);
}

/// A pair of numbers of any size, or of hard ones.
inline std::pair<Linear, Linear> some_pair(Random& random) {
  const double size = random.below(4) ? 2 : random.log_uniform(1e-3, 1e3);
  const double reach = size * random.log_uniform(1e-9, 2);
  const int symbols = 1 + random.below(static_cast<int>(AffineForm::symbols));
  Linear x = some_linear(random, -size, size, reach, symbols), y = some_linear(random, -size, size, reach, symbols);
  if (!random.below(8)) x.centre = 0;
  if (!random.below(8)) y = {std::ldexp(1.0, random.below(9) - 4), {}};
  if (!random.below(8)) x = {random.uniform(-size, size), {}};
  return {x, y};
}

} // namespace refraster
