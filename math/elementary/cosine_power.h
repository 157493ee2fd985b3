#pragma once
// The highlight of Phong and Blinn-Phong: a cosine to a power that may be a million. It is where shading spends its
// time.

#include "math/elementary/exp_log.h"
#include "math/elementary/whole_power.h"
#include "math/vec.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace refraster::inline REFRASTER_KIT {

/// The relative error of a result r of small_power is at most (2 + 4 |log2 r|) u, u = epsilon / 2. That is much for a
/// tiny r, but never more than 3 u of 1: r (2 + 4 |log2 r|) is greatest around r = 1/2.
inline constexpr double small_power_error_at_1 = 2, small_power_error_per_bit = 4;

/// ((1 + t) 2^k)^s <= 1, for 1 + t in [sqrt(1/2), sqrt(2)], k <= 0 and a finite s >= 0. For float, s is rounded to
/// float, and counts as the largest one if it is larger. Results below 2^lowest_power are cut to 0. Exactly 1 for t = k
/// = 0.
template <Lanes T>
T small_power(const OnePlus<T>& base, double s) {
  using F = RealOf<T>;
  const T exponent = as<T>(std::min(s, static_cast<double>(std::numeric_limits<F>::max())));
  const T y = (base.k + plain_log2_of_1_plus(base.t)) * exponent;
  const auto [f, n] = rounded(max(y, as<T>(lowest_power<F> - 1)));
  const T result = times_power_of_2(T(1) + plain_exp2_minus_1(f), n);
  return select(result >= as<T>(smallest_result<F>), result, T(0));
}

/// Absolute error of cosine_power for s >= 1, against the exact angle between the two vectors: see there.
template <class F>
inline constexpr double cosine_power_max_error = 24 * static_cast<double>(std::numeric_limits<F>::epsilon()) / 2;

/// The largest exponent that raise_to_whole_power takes: with it, what hi alone is off by is still within the error of
/// small_power for results as small as min_two_product.
inline constexpr auto max_whole_exponent =
    static_cast<std::uint32_t>((small_power_error_at_1 + small_power_error_per_bit * 960) / 2);
static_assert(min_two_product<double> == 0x1p-960);
static_assert(whole_power_error<double>(max_whole_exponent) < small_power_error_at_1);
static_assert(whole_power_error<float>(max_whole_exponent) < small_power_error_at_1);

/// An exponent s >= 0 of cosine_power, with what is the same for all cosines.
template <class F>
struct CosineExponent {
  double s = 0;
  std::uint32_t whole = 0; // s where raise_to_whole_power takes it; else 0
  double least = 0;        // with it, a cosine whose power is cut to 0, and normal in F
};

template <class F>
CosineExponent<F> cosine_exponent(double s) {
  if (!(s >= 1 && s <= max_whole_exponent)) return {s};
  const auto n = static_cast<std::uint32_t>(s);
  if (static_cast<double>(n) != s) return {s};
  // 2^-5 below what is cut: the power of a rounded root is not off by that.
  return {s, n, square(exp2((lowest_power<F> - 5) / (2 * s)))};
}

/// What cosine_power takes for the cosine of a and b, |a - b|^2 / 2 being q: 1 - q is the better one down to 1/2, as
/// the lengths of a and b, which are not quite 1, enter by q instead of 1 - q.
template <Lanes T>
T cosine_of(const Vec3<T>& a, const Vec3<T>& b, const T& q) {
  const T cosine = dot(a, b);
  if constexpr (sizeof(RealOf<T>) == 8) return select(cosine > T(0.5), T(1) - q, cosine);
  else return cosine;
}

/// cosine = cosine^s for a whole s; q where the cosine is above 3/4 is 1 less it, but more exactly. N at once.
template <std::size_t N, Lanes T>
void raise_cosines(T (&cosine)[N], T (&q)[N], const CosineExponent<RealOf<T>>& exponent) {
  using F = RealOf<T>;
  for (std::size_t i = 0; i < N; ++i) {
    const MaskOf<T> is_near = cosine[i] > T(F(0.75));
    if constexpr (sizeof(F) == 8) {
      q[i] = select(is_near, (T(1) - cosine[i]) - q[i], T(0));
      cosine[i] = max(cosine[i], as<T>(exponent.least));
    } else {
      q[i] = select(is_near, min(q[i], T(F(0.25))), T(0)); // more only where vectors are not unit
      cosine[i] = select(is_near, T(1), cosine[i]);
    }
  }
  if constexpr (sizeof(F) == 8) raise_to_whole_power(cosine, q, exponent.whole);
  else raise_to_whole_power(cosine, q, exponent.least, exponent.whole);
  for (T& power : cosine) power = select(power >= as<T>(smallest_result<F>), power, T(0));
}

/// The same for any s. Out of line: nearly every material has a whole glossiness.
template <Lanes T>
[[gnu::noinline, gnu::flatten]] T any_cosine_power(T cosine, T q, double s) {
  using F = RealOf<T>;
  if (s == 0) return T(1);
  q = min(q, T(F(0.25))); // more only where vectors are not unit
  const MaskOf<T> is_near = cosine > T(F(0.75));
  const T smallest(std::numeric_limits<F>::min());
  const auto [m, k] = binary(max(cosine, smallest), F(sqrt_half));
  const OnePlus<T> base = {select(is_near, -q, m - T(1)), select(is_near, T(0), k)};
  return select(cosine >= smallest, small_power(base, s), T(0));
}

/// cosine_power(a, b, s), see below, with q = |a - b|^2 / 2 given: more exactly than it follows from rounded a and b;
/// and with `cosine` as cosine_of() makes it.
template <Lanes T>
T cosine_power(const T& cosine, const T& q, const CosineExponent<RealOf<T>>& exponent) {
  if (exponent.whole == 0) return any_cosine_power<T>(cosine, q, exponent.s);
  T power[] = {cosine}, half_square[] = {q};
  raise_cosines(power, half_square, exponent);
  return power[0];
}

/// max(a.b, 0)^s for unit vectors a and b (0 counts as perpendicular to all) and a finite s >= 0. Exactly 1 where a ==
/// b, never above 1; zero to the zero is 1. Cosines below the smallest normal number count as 0, and results below
/// 2^lowest_power are 0. Absolute error for s >= 1: cosine_power_max_error, however large s is.
///
/// Why not pow(dot(a, b), s): an exponent of a million turns the rounding of the dot product, 2^-24 in float, into an
/// error of 6 %, and lets a cosine of 1 + 2^-23 shine brighter than the light. But for unit vectors
///     1 - a.b = |a - b|^2 / 2 =: q,
/// and each component of a - b is a difference with one rounding, so q is good to a few units in *its* last place,
/// however small it is, and (1 - q)^s = 2^(s log2(1 - q)) loses nothing. That a and b are rounded to lengths 1 + d and
/// 1 + e matters little:
///     |a - b|^2 / 2 = (1 + d)(1 + e)(1 - cos) + (d - e)^2 / 2,
/// a relative error of d + e in q, and an absolute one of the square of a rounding.
///
/// The bound, with u = epsilon / 2. `normalize` leaves d, e <= 4.5 u: three roundings of the squared length, halved by
/// the root, and one each of root, reciprocal and product. Above a cosine of 3/4 q decides; it has a relative error of
/// at most r = 5 u + d + e = 14 u (a difference twice, a square, two sums), which changes the result by r s q (1 -
/// q)^(s-1) <= 0.43 r = 6 u for q <= 1/4 and any s. Below, the dot product does, with an absolute error of at most 3 u
/// + d + e = 12 u (a product, two sums), which changes the result by 12 u s c^(s-1) <= 1.7 * 12 u = 21 u for c <= 3/4
/// and s >= 1 (a root, s < 1, is steep at c = 0). The power itself adds 3 u, a whole one hardly more than 1 u: 24 u in
/// all. As the vectors' own rounding is most of it, a more exact logarithm would buy nothing.
template <Lanes T>
T cosine_power(const Vec3<T>& a, const Vec3<T>& b, double s) {
  const T q = T(RealOf<T>(0.5)) * squared_length(a - b);
  return cosine_power(cosine_of(a, b, q), q, cosine_exponent<RealOf<T>>(s));
}

} // namespace refraster::inline REFRASTER_KIT
