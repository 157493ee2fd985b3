#pragma once
// Logarithm and exponential to base 2. Each exists twice: in double for double lanes, to twice the precision where a
// power needs it; and in double for float lanes, with polynomials just long enough, so that rounding the result to
// float is nearly the only error. Widening costs half the lanes, compensated float arithmetic would cost more.
// The polynomials come from tests/unit/math/fit_polynomials.py.

#include "math/elementary/double_double.h"
#include "math/elementary/polynomial.h"
#include "math/elementary/ulp_bound.h"

namespace refraster::inline REFRASTER_KIT {

template <class F>
inline constexpr UlpBound log2_error = sizeof(F) == 4 ? UlpBound{0.502, 0.5} : UlpBound{0.51, 0.5};
template <class F>
inline constexpr UlpBound exp2_error = sizeof(F) == 4 ? UlpBound{0.6, 0.52} : UlpBound{0.66, 0.55};

/// Results of exp2 and pow below 2^lowest_power are cut to 0, far above the subnormal numbers: one subnormal in a
/// register costs every lane an excursion into microcode, and no image shows the difference.
template <class F>
inline constexpr double lowest_power = sizeof(F) == 4 ? -120 : -1000;
template <class F>
inline constexpr double smallest_result = sizeof(F) == 4 ? 0x1p-120 : 0x1p-1000; // 2^lowest_power
template <class F>
inline constexpr double highest_power = std::numeric_limits<F>::max_exponent; // 2^this overflows

inline constexpr DoubleDouble<double> two_over_ln2 = {0x1.71547652b82fep+1, 0x1.777d0ffda0d24p-55};
inline constexpr DoubleDouble<double> two_thirds_over_ln2 = {0x1.ec709dc3a03fdp-1, 0x1.d27f05548af0cp-55};
inline constexpr DoubleDouble<double> ln_of_2 = {0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
inline constexpr DoubleDouble<double> log2_of_1_5 = {0x1.2b803473f7ad1p-1, -0x1.817fd3b7d7e5dp-58};

/// x = m 2^exponent with m in [least, 2 least), for normal x > 0.
template <class T>
struct Binary {
  T m, exponent;
};
template <Lanes T>
Binary<T> binary(const T& x, RealOf<T> least) {
  using F = RealOf<T>;
  constexpr int shift = fraction_bits<F>;
  constexpr BitsOf<F> bias = std::numeric_limits<F>::max_exponent - 1;
  const LaneBits<T> bits = bits_of(x);
  const LaneBits<T> biased = shift_right<T>(bits + (one_bits<T> - bits_of(least)), shift);
  return {from_bits<T>(bits - ((biased - bias) << shift)), to_number<T>(biased, -bias)};
}

/// The largest float, as a double: a result is held below it before it is rounded to float.
inline constexpr double largest_float = 0x1.fffffep127;

/// n + fraction = x: n the nearest whole number (ties to even), |x| < 2^(fraction_bits - 1).
template <class T>
struct Rounded {
  T fraction;
  UnsignedLaneBits<T> n; // only the lowest bits: two's complement
};
template <Lanes T>
Rounded<T> rounded(const T& x) {
  // With 1.5 2^fraction_bits added, the last place is worth 1: the sum is rounded to it, and ends in the bits of n.
  const T bias(RealOf<T>(1.5) * integer_rounding_bias<T>);
  const T biased = x + bias;
  return {x - (biased - bias), std::bit_cast<UnsignedLaneBits<T>>(biased)};
}

/// m 2^n for m in [1/2, 2), where the result is normal.
template <Lanes T>
T times_power_of_2(const T& m, const UnsignedLaneBits<T>& n) {
  return std::bit_cast<T>(std::bit_cast<UnsignedLaneBits<T>>(m) + (n << fraction_bits<RealOf<T>>));
}

/// What the logarithm of x = m 2^k is made from:
///     log2(x) = k + log2(c) + log2((1 + z) / (1 - z)),   z = (m - c) / (m + c)
template <class T>
struct Log2Argument {
  T k;
  T difference; // m - c: exact
  T c, m;       // c >= m, or both of one binade
  DoubleDouble<T> log2_c;
};

/// For finite x > 0. c is 1 or 3/2, so that |m - c| / (m + c) <= 0.1011.
template <Lanes T>
  requires(sizeof(RealOf<T>) == 8)
Log2Argument<T> log2_argument(const T& x) {
  const MaskOf<T> subnormal = x < T(std::numeric_limits<double>::min());
  const auto [m, k] = binary(select(subnormal, x * T(0x1p54), x), 0x1.bb67ae8584caap-1); // m in [sqrt(3)/2, sqrt(3))
  const MaskOf<T> high = m > T(0x1.3988e1409212ep+0);                                    // sqrt(3/2)
  const T c = select(high, T(1.5), T(1));
  const DoubleDouble<T> log2_c = {select(high, T(log2_of_1_5.hi), T(0)), select(high, T(log2_of_1_5.lo), T(0))};
  return {k - select(subnormal, T(54), T(0)), m - c, c, m, log2_c};
}

/// The logarithm with a relative error below 2^-66.
///     log2((1 + z) / (1 - z)) = z (A + w (A/3 + w q(w))),   w = z^2,   A = 2 / ln 2
/// The tail w q(w) adds at most 2^-7 of A/3, and w A/3 2^-8 of A: so q is needed to single, the rest to twice
/// precision.
template <Lanes T>
DoubleDouble<T> wide_log2(const Log2Argument<T>& x) {
  // q(w) within 5.5e-21 / w^2 for w in [0, 0.01021].
  constexpr std::array q = {0x1.2776c50ef9bd0p-1, 0x1.a61762a7cbc62p-2, 0x1.484b139e1606dp-2,
                            0x1.0c9abb3e965f5p-2, 0x1.c658d23e95b77p-3, 0x1.97aaebd9d94eep-3};
  const DoubleDouble<T> sum = fast_two_sum(x.c, x.m);
  const T reciprocal = T(1) / sum.hi;
  const T quotient = x.difference * reciprocal;
  const DoubleDouble<T> back = two_product(quotient, sum.hi);
  const T rest = ((x.difference - back.hi) - back.lo) - quotient * sum.lo;
  const DoubleDouble<T> z = fast_two_sum(quotient, rest * reciprocal);
  const DoubleDouble<T> w = two_product(z, z);
  const DoubleDouble<T> third = as<T>(two_thirds_over_ln2), all = as<T>(two_over_ln2);
  const DoubleDouble<T> inner = fast_two_sum(third.hi, third.lo + w.hi * polynomial(w.hi, q));
  const DoubleDouble<T> tail = two_product(w, inner);
  const DoubleDouble<T> factor = fast_two_sum(all.hi, tail.hi);
  const DoubleDouble<T> log2_m = two_product(z, {factor.hi, factor.lo + (tail.lo + all.lo)});
  const DoubleDouble<T> whole = two_sum(x.k, x.log2_c.hi);
  const DoubleDouble<T> result = two_sum(whole.hi, log2_m.hi);
  return fast_two_sum(result.hi, result.lo + (whole.lo + x.log2_c.lo + log2_m.lo));
}

/// 2^(y.hi + y.lo) for -1022 <= y.hi < 1024.
template <Lanes T>
T wide_exp2(const DoubleDouble<T>& y) {
  // (2^f - 1 - f ln2) / f^2 within 1.2e-17 for |f| <= 1/2.
  constexpr std::array p = {0x1.ebfbdff82c58fp-3,  0x1.c6b08d704a0c2p-5,  0x1.3b2ab6fba4e79p-7,  0x1.5d87fe78a5275p-10,
                            0x1.430912f86b061p-13, 0x1.ffcbfc670dfa0p-17, 0x1.62c0224555c35p-20, 0x1.b524fae5b6938p-24,
                            0x1.e4cf04ec53e47p-28, 0x1.e9d3feff50da6p-32, 0x1.c4b5aee3ce99ep-36};
  const auto [fraction, n] = rounded(y.hi);
  const DoubleDouble<T> f = fast_two_sum(fraction, y.lo);
  // 2^f = 1 + ln2 f + f^2 p(f): the first two terms to twice the precision, the third is below 0.07.
  const DoubleDouble<T> linear = two_product(f.hi, T(ln_of_2.hi));
  const DoubleDouble<T> sum = fast_two_sum(T(1), linear.hi);
  const T rest = f.hi * f.hi * polynomial(f.hi, p) + (linear.lo + f.hi * T(ln_of_2.lo));
  const T m = sum.hi + (sum.lo + (rest + f.lo * (T(ln_of_2.hi) * sum.hi)));
  return times_power_of_2(m, n);
}

/// k + log2(1 + t) for float lanes, in double: 1 + t in [sqrt(1/2), sqrt(2)]. Relative error below 2^-33 where k = 0.
template <Lanes T>
T narrow_log2(const T& k, const T& t) {
  // log2(1 + t) / t within 1.1e-10 of it.
  constexpr std::array p = {0x1.71547652ef9f3p+0, -0x1.7154767bad52ep-1, 0x1.ec709c00c8e65p-2, -0x1.715435ec2e848p-2,
                            0x1.277732d9f9739p-2, -0x1.ec8d73c9543f5p-3, 0x1.a615c8f669af8p-3, -0x1.6eb02972eb972p-3,
                            0x1.45a2ab702556cp-3, -0x1.41800aa78f070p-3, 0x1.3d259f0ac9b3bp-3, -0x1.61ab39fbf0aa0p-4};
  return k + t * polynomial(t, p);
}

/// 2^y for float lanes, in double, |y| <= 1022. Relative error below 2^-27.4.
template <Lanes T>
T narrow_exp2(const T& y) {
  // (2^f - 1) / f within 7.5e-9 for |f| <= 1/2.
  constexpr std::array p = {0x1.62e4302fcf031p-1, 0x1.ebfbe07d594d8p-3,  0x1.c6af6cccf54bdp-5,
                            0x1.3b29e40dfe0c2p-7, 0x1.5f08975d6cc11p-10, 0x1.446c521b4a8c5p-13};
  const auto [f, n] = rounded(y);
  return times_power_of_2(T(1) + f * polynomial(f, p), n);
}

inline constexpr double sqrt_half = 0x1.6a09e667f3bcdp-1;

/// x = (1 + t) 2^k, 1 + t in [sqrt(1/2), sqrt(2)], for x > 0 and finite; subnormal x too.
template <class T>
struct OnePlus {
  T t, k;
};
template <Lanes T>
OnePlus<T> one_plus(const T& x) {
  const MaskOf<T> subnormal = x < T(std::numeric_limits<RealOf<T>>::min());
  const auto [m, k] = binary(select(subnormal, x * T(0x1p24f), x), RealOf<T>(sqrt_half));
  return {m - T(1), k - select(subnormal, T(24), T(0))}; // both exact
}

/// log2(1 + t) for 1 + t in [sqrt(1/2), sqrt(2)], in plain arithmetic of T: a few units in the last place.
template <Lanes T>
T plain_log2_of_1_plus(const T& t) {
  if constexpr (is_fast<T>) {
    // Within 7.4e-6 of it.
    constexpr std::array p = {0x1.7154e49cfc02ap+0,  -0x1.7141f66ec5556p-1, 0x1.eb53d547a4f18p-2,
                              -0x1.7749aa263ebd7p-2, 0x1.45d6043773532p-2,  -0x1.a646ca1906908p-3};
    return t * polynomial(t, p);
  } else if constexpr (sizeof(RealOf<T>) == 4) {
    // log2(1 + t) / t within 2.7e-8 of it.
    constexpr std::array p = {0x1.715475b2cdaa5p+0,  -0x1.715470811e781p-1, 0x1.ec73d6ff050ccp-2,
                              -0x1.715c4d4aed8f2p-2, 0x1.26d38103e236ep-2,  -0x1.e95c0e8ab0104p-3,
                              0x1.b9c981fd6b89ap-3,  -0x1.a87c3efbcb66dp-3, 0x1.01b4ddd7310ddp-3};
    return t * polynomial(t, p);
  } else {
    // Within 3.6e-17 of it.
    constexpr std::array p = {0x1.71547652b82fep+0, -0x1.71547652b8304p-1, 0x1.ec709dc3a0392p-2, -0x1.71547652b6764p-2,
                              0x1.2776c50f00080p-2, -0x1.ec709dc6123e3p-3, 0x1.a61762a4490e7p-3, -0x1.71547587c2e36p-3,
                              0x1.484b13da2b7b7p-3, -0x1.2776e8a86f2e1p-3, 0x1.0c9aa82196216p-3, -0x1.ec69641a557e1p-4,
                              0x1.c681ff35f1214p-4, -0x1.a683dd436bee9p-4, 0x1.8b195cf129053p-4, -0x1.6e032d06c89b8p-4,
                              0x1.4e5585195f558p-4, -0x1.4f973326c0bfcp-4, 0x1.82138c4e4bc0cp-4, -0x1.6302aba8df85fp-4,
                              0x1.352ef402b65c8p-5};
    return t * polynomial(t, p);
  }
}

/// 2^f - 1 for |f| <= 1/2, likewise.
template <Lanes T>
T plain_exp2_minus_1(const T& f) {
  if constexpr (is_fast<T>) {
    // Within 2.7e-6.
    constexpr std::array p = {0x1.62e0d32206b7bp-1, 0x1.ebf892df78400p-3, 0x1.ca181e5d46554p-5, 0x1.3d41b7d85cb6fp-7};
    return f * polynomial(f, p);
  } else if constexpr (sizeof(RealOf<T>) == 4) {
    // (2^f - 1) / f within 7.5e-9.
    constexpr std::array p = {0x1.62e4302fcf031p-1, 0x1.ebfbe07d594d8p-3,  0x1.c6af6cccf54bdp-5,
                              0x1.3b29e40dfe0c2p-7, 0x1.5f08975d6cc11p-10, 0x1.446c521b4a8c5p-13};
    return f * polynomial(f, p);
  } else {
    // Within 4.1e-17.
    constexpr std::array p = {0x1.62e42fefa39efp-1,  0x1.ebfbdff82c598p-3,  0x1.c6b08d704a0cbp-5,
                              0x1.3b2ab6fba1dd9p-7,  0x1.5d87fe78a2cbep-10, 0x1.43091309700efp-13,
                              0x1.ffcbfc7440a5cp-17, 0x1.62bfd476eb05fp-20, 0x1.b524dcbc2217ep-24,
                              0x1.e60640647cf48p-28, 0x1.ea043fab9bb35p-32};
    return f * polynomial(f, p);
  }
}

/// log2(x), always finite: x below the smallest positive number (0, negative, NaN) counts as that number, x above the
/// largest as that. Error: log2_error.
template <Lanes T>
T log2(const T& x) {
  using F = RealOf<T>;
  const T inside = min(max(x, T(std::numeric_limits<F>::denorm_min())), T(std::numeric_limits<F>::max()));
  if constexpr (is_fast<T>) {
    const auto [t, k] = one_plus(inside);
    return k + plain_log2_of_1_plus(t);
  } else if constexpr (sizeof(F) == 4) {
    const auto [t, k] = one_plus(inside);
    return in_double([]<class D>(const D& k_double, const D& t_double) { return narrow_log2(k_double, t_double); }, k,
                     t);
  } else {
    const DoubleDouble<T> result = wide_log2(log2_argument(inside));
    return result.hi + result.lo;
  }
}

/// 2^x, always finite: 0 below x = lowest_power and for NaN, the largest number where the result would overflow.
/// Error: exp2_error.
template <Lanes T>
T exp2(const T& x) {
  using F = RealOf<T>;
  const T inside = min(max(x, T(F(lowest_power<F>) - 1)), T(F(highest_power<F>)));
  T result;
  if constexpr (is_fast<T>) {
    const auto [f, n] = rounded(inside);
    result = min(times_power_of_2(T(1) + plain_exp2_minus_1(f), n), T(std::numeric_limits<F>::max()));
  } else if constexpr (sizeof(F) == 4) {
    result = in_double([]<class D>(const D& y) { return min(narrow_exp2(y), D(largest_float)); }, inside);
  } else {
    result = min(wide_exp2(DoubleDouble<T>{inside, T(0)}), T(std::numeric_limits<double>::max()));
  }
  return select(inside >= T(F(lowest_power<F>)), result, T(0));
}

} // namespace refraster::inline REFRASTER_KIT
