#pragma once
// Powers, as highlights need them: a cosine to an exponent that may be a million.

#include "math/exp_log.h"
#include "math/vec.h"

namespace refraster {

template <class F>
inline constexpr UlpBound power_error = sizeof(F) == 4 ? UlpBound{0.7, 0.55} : UlpBound{0.7, 0.55};

/// 2^(s log2(x)) for double lanes, x as taken apart in `base`.
template <Lanes T>
  requires(sizeof(RealOf<T>) == 8)
T power_of(const Log2Argument<T>& base, double s) {
  const Twofold<T> log2_x = wide_log2(base);
  Twofold<T> y = wide_product(T(s), log2_x.hi);
  y.lo = y.lo + T(s) * log2_x.lo;
  // Outside the range y.lo may be anything, also NaN: the selects below take no notice of the result then.
  const T inside = minimum(maximum(y.hi, T(lowest_power<double> - 1)), T(highest_power<double>));
  const T in_range = select(y.hi < T(highest_power<double>), wide_exp2(Twofold<T>{inside, y.lo}),
                            T(std::numeric_limits<double>::max()));
  return select(y.hi >= T(lowest_power<double>), in_range, T(0));
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
/// 0, one that would overflow is the largest number. Error: power_error. Never above 1 for x <= 1.
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

/// Absolute error of cosine_power for s >= 1, against the exact angle between the two vectors: see there.
template <class F>
inline constexpr double cosine_power_max_error = 14 * static_cast<double>(std::numeric_limits<F>::epsilon()) / 2;

/// max(a.b, 0)^s for unit vectors a and b (0 counts as perpendicular to all), s >= 0: the highlight of Phong and
/// Blinn-Phong. Exactly 1 where a == b, never above 1; zero to the zero is 1. Cosines below the smallest normal number
/// count as 0. Absolute error for s >= 1: cosine_power_max_error, however large s is.
///
/// Why not power(dot(a, b), s): an exponent of a million turns the rounding of the dot product, 2^-24 in float, into an
/// error of 6 %, and lets a cosine of 1 + 2^-23 shine brighter than the light. But for unit vectors
///     1 - a.b = |a - b|^2 / 2 =: q,
/// and each component of a - b is a difference with one rounding, so q is good to a few units in *its* last place,
/// however small it is, and (1 - q)^s = 2^(s log2(1 - q)) loses nothing. That a and b are rounded to lengths 1 + d and
/// 1 + e matters little:
///     |a - b|^2 / 2 = (1 + d)(1 + e)(1 - cos) + (d - e)^2 / 2,
/// a relative error of d + e in q, and an absolute one of the square of a rounding.
///
/// The bound, with u = epsilon / 2 and d, e <= 2 u for a normalised vector. Above a cosine of 3/4 q decides; it has a
/// relative error of at most r = 5 u + d + e = 9 u (a difference twice, a square, two sums), which changes the result
/// by r s q (1 - q)^(s-1) <= 0.43 r for q <= 1/4 and any s. Below, the dot product does, with an absolute error of at
/// most 3 u + d + e = 7 u (a product, two sums), which changes the result by 7 u s c^(s-1) <= 1.7 * 7 u for c <= 3/4
/// and s >= 1 (a root, s < 1, is steep at c = 0). Rounding the result adds at most 2 u: 14 u in all.
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
