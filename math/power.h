#pragma once
// Powers, as highlights need them: a cosine to an exponent that may be a million.

#include "math/exp_log.h"
#include "math/vec.h"

namespace refraster {

/// Maximal error of power, in units in the last place; and of cosine_power for a given q (see there).
template <class F>
inline constexpr double power_max_ulp = sizeof(F) == 4 ? 0.6 : 1.0;

/// 2^(s log2(x)) for double lanes, x as taken apart in `base`.
template <Lanes T>
  requires(sizeof(RealOf<T>) == 8)
T power_of(const Log2Argument<T>& base, double s) {
  const Twofold<T> log2_x = wide_log2(base);
  Twofold<T> y = wide_product(T(s), log2_x.hi);
  y.lo = y.lo + T(s) * log2_x.lo;
  // Outside the range y.lo may be anything, also NaN: the selects below take no notice of the result then.
  const T inside = minimum(maximum(y.hi, T(lowest_power<double> - 1)), T(highest_power<double>));
  const T result = minimum(wide_exp2(Twofold<T>{inside, y.lo}), T(std::numeric_limits<double>::max()));
  return select(y.hi >= T(lowest_power<double>), result, T(0));
}

/// ((1 + t) 2^k)^s for float lanes.
template <Lanes T>
  requires(sizeof(RealOf<T>) == 4)
T power_of(const OnePlus<T>& base, double s) {
  const auto in_range = [s]<class D>(const D& k, const D& t) {
    const D y = narrow_log2(k, t) * D(s);
    return minimum(narrow_exp2(minimum(maximum(y, D(lowest_power<float> - 1)), D(highest_power<float>))),
                   D(largest_float));
  };
  const T result = in_double(in_range, base.k, base.t);
  return select(result >= T(0x1p-120f), result, T(0));
}

/// x^s for s >= 0; x^0 = 1, also for x = 0; x < 0 and NaN count as 0. Always finite: a result below 2^lowest_power is
/// 0, one that would overflow is the largest number. Error: power_max_ulp. Never above 1 for x <= 1.
template <Lanes T>
T power(const T& x, double s) {
  using F = RealOf<T>;
  const T largest(std::numeric_limits<F>::max());
  if (s == 0) return T(1);
  const MaskOf<T> is_positive = x > T(0);
  const T base = minimum(select(is_positive, x, T(1)), largest);
  T result;
  if constexpr (sizeof(F) == 4) {
    result = power_of(one_plus(base), s);
  } else {
    const MaskOf<T> subnormal = base < T(std::numeric_limits<F>::min());
    Log2Argument<T> argument = log2_argument(select(subnormal, base * T(0x1p54), base));
    argument.k = argument.k - select(subnormal, T(54), T(0));
    result = power_of(argument, s);
  }
  return select(is_positive, result, T(0));
}

/// max(a.b, 0)^s for unit vectors a and b (0 counts as perpendicular to all), s >= 0: the highlight of Phong and
/// Blinn-Phong. Exactly 1 where a == b, never above 1; otherwise as `power`.
///
/// Why not power(dot(a, b), s): an exponent of a million turns the rounding of the dot product, 2^-24 in float, into an
/// error of 6 %, and lets a cosine of 1 + 2^-23 shine brighter than the light. But for unit vectors
///     1 - a.b = |a - b|^2 / 2 =: q,
/// and differences of nearby numbers are exact, so q is good to a few units in *its* last place, however small it is:
/// cos^s = 2^(s log2(1 - q)) loses nothing. That a and b are rounded to lengths 1 + d and 1 + e matters little:
///     |a - b|^2 / 2 = (1 + d)(1 + e)(1 - cos) + (d - e)^2 / 2,
/// a relative error of d + e in q, and an absolute one of the square of a rounding.
/// An error of r q in q changes the result by at most r s q (1 - q)^(s-1) <= 1.4 r, whatever s is.
/// Above a cosine of 3/4 q decides, below it the dot product, where the same is true of it.
template <Lanes T>
T cosine_power(const Vec3<T>& a, const Vec3<T>& b, double s) {
  using F = RealOf<T>;
  if (s == 0) return T(1);
  const T cosine = dot(a, b);
  const T q = minimum(T(F(0.5)) * squared_length(a - b), T(F(0.5))); // more only where a or b is not unit
  const MaskOf<T> is_near = cosine > T(F(0.75)), is_positive = cosine >= T(std::numeric_limits<F>::min());
  const T some_cosine = select(is_positive, cosine, T(1));
  if constexpr (sizeof(F) == 4) {
    const auto [m, k] = binary(some_cosine, F(sqrt_half));
    const OnePlus<T> base = {select(is_near, -q, m - T(1)), select(is_near, T(0), k)};
    return select(is_positive, power_of(base, s), T(0));
  } else {
    const Log2Argument<T> argument = select(is_near, log2_argument_of_1_minus(q), log2_argument(some_cosine));
    return select(is_positive, power_of(argument, s), T(0));
  }
}

} // namespace refraster
