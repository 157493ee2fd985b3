#pragma once
// Powers of any positive number, nearly correctly rounded. For highlights there is math/elementary/cosine_power.h.

#include "math/elementary/exp_log.h"

namespace refraster::inline REFRASTER_KIT {

template <class F>
inline constexpr UlpBound pow_error = {0.7, 0.55};

/// 2^(s log2(x)) for double lanes, x as taken apart in `base`.
template <Lanes T>
  requires(sizeof(RealOf<T>) == 8)
T power_of(const Log2Argument<T>& base, double s) {
  const DoubleDouble<T> log2_x = wide_log2(base);
  DoubleDouble<T> y = two_product(T(s), log2_x.hi);
  y.lo = y.lo + T(s) * log2_x.lo;
  // Outside the range y.lo may be anything, also NaN: the selects below take no notice of the result then.
  const T inside = min(max(y.hi, T(lowest_power<double> - 1)), T(highest_power<double>));
  const T in_range = select(y.hi < T(highest_power<double>), wide_exp2(DoubleDouble<T>{inside, y.lo}),
                            T(std::numeric_limits<double>::max()));
  return select(y.hi >= T(lowest_power<double>), in_range, T(0));
}

/// ((1 + t) 2^k)^s for float lanes.
template <Lanes T>
  requires(sizeof(RealOf<T>) == 4)
T power_of(const OnePlus<T>& base, double s) {
  if constexpr (is_fast<T>) {
    return exp2((base.k + plain_log2_of_1_plus(base.t)) * as<T>(s));
  } else {
    const auto in_range = [s]<class D>(const D& k, const D& t) {
      const D y = narrow_log2(k, t) * D(s);
      return min(narrow_exp2(min(max(y, D(lowest_power<float> - 1)), D(highest_power<float>))), D(largest_float));
    };
    const T result = in_double(in_range, base.k, base.t);
    return select(result >= as<T>(smallest_result<float>), result, T(0));
  }
}

/// x^s for s >= 0; x^0 = 1, also for x = 0; x < 0 and NaN count as 0. Always finite: a result below 2^lowest_power is
/// 0, one that would overflow is the largest number. Error: pow_error. Never above 1 for x <= 1.
template <Lanes T>
T pow(const T& x, double s) {
  using F = RealOf<T>;
  const T largest(std::numeric_limits<F>::max());
  if (s == 0) return T(1);
  const MaskOf<T> is_positive = x > T(0);
  const T base = min(select(is_positive, x, T(1)), largest);
  if constexpr (sizeof(F) == 4) return select(is_positive, power_of(one_plus(base), s), T(0));
  else return select(is_positive, power_of(log2_argument(base), s), T(0));
}

} // namespace refraster::inline REFRASTER_KIT
