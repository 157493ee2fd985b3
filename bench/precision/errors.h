#pragma once
// Many errors of one kind: their maximum, the value that 99 of 100 keep to, and where the worst one was.

#include "bench/precision/exact_vectors.h"
#include "math/exact.h"

#include <string>

namespace refraster::precision {

/// One unit in the last place of F at x, a number of Boost's: the distance of neighbouring numbers in its binade.
template <class F, class X>
X ulp_at(const X& x) {
  int exponent = std::numeric_limits<F>::min_exponent;
  if (x != 0) {
    int of_x = 0;
    frexp(X(abs(x)), &of_x);
    exponent = std::max(exponent, of_x);
  }
  return ldexp(X(1), exponent - std::numeric_limits<F>::digits);
}

struct Error {
  double max = 0, mostly = 0; // `mostly`: 99 of 100 do not exceed it
  std::string worst;          // the input that gave the maximum, in hexadecimal numbers
};

class Errors {
public:
  /// describe() is called only for a new maximum. An error that is NaN counts as infinite.
  template <class Describe>
  void add(double error, const Describe& describe) {
    const double counted = error >= 0 ? error : std::numeric_limits<double>::infinity();
    if (all_.empty() || counted > max_) {
      max_ = counted;
      worst_ = describe();
    }
    all_.push_back(counted);
  }
  void add(const Mpfr& error, const auto& describe) { add(error.template convert_to<double>(), describe); }
  void add(const Exact& error, const auto& describe) { add(static_cast<double>(error), describe); }

  Error summary() {
    if (all_.empty()) return {};
    const auto nth = all_.begin() + static_cast<std::ptrdiff_t>(all_.size() * 99 / 100);
    std::nth_element(all_.begin(), nth, all_.end());
    return {max_, *nth, worst_};
  }

private:
  std::vector<double> all_;
  double max_ = 0;
  std::string worst_;
};

/// "0x1.8p+0": a float or double to the last bit.
std::string hex(double x);
std::string hex(const Double3& a);

} // namespace refraster::precision
