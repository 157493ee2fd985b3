#pragma once
// How far a computed number is from the exact one, in units in the last place.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <boost/multiprecision/mpfr.hpp>

namespace refraster {

/// 60 digits by MPFR: errors below a millionth of an ulp even of a result that cancels to half its digits.
using Mpfr =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<60, boost::multiprecision::allocate_stack>>;

/// |computed - exact| in ulps of F at `exact`: the distance of neighbouring numbers in its binade.
template <class F>
double ulp_error(F computed, const Mpfr& exact) {
  if (exact == 0) return computed == 0 ? 0 : std::numeric_limits<double>::infinity();
  int exponent = 0; // |exact| in [2^(exponent - 1), 2^exponent)
  frexp(Mpfr(abs(exact)), &exponent);
  exponent = std::max(exponent, std::numeric_limits<F>::min_exponent);
  const Mpfr ulp = ldexp(Mpfr(1), exponent - std::numeric_limits<F>::digits);
  return Mpfr(abs(Mpfr(computed) - exact) / ulp).template convert_to<double>();
}

/// Errors of many trials.
class UlpErrors {
public:
  void add(double ulp) { all_.push_back(ulp); }
  double max() const { return *std::max_element(all_.begin(), all_.end()); }
  /// The value that 99 of 100 errors do not exceed.
  double percentile_99() {
    const auto nth = all_.begin() + static_cast<std::ptrdiff_t>(all_.size() * 99 / 100);
    std::nth_element(all_.begin(), nth, all_.end());
    return *nth;
  }

private:
  std::vector<double> all_;
};

} // namespace refraster
