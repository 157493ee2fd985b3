#pragma once
// Affine numbers with known points in them, and how tight what was computed from them is.

#include "tests/support/random.h"

#include "math/bounds/affine_functions.h"

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

} // namespace refraster
