#pragma once
// Numbers of twice the precision: an unevaluated sum hi + lo with |lo| <= ulp(hi) / 2. Only + - * and bit masks, since
// a fused multiply-add, which would shorten this, is not on every machine and would change bits where it is. Dekker, "A
// floating-point technique for extending the available precision", 1971.

#include "math/lane_bits.h"

namespace refraster {

template <class T>
struct Twofold {
  T hi, lo;
};

/// a + b exactly, for |a| >= |b| or a and b of one binade, or a = 0.
template <Lanes T>
Twofold<T> quick_sum(const T& a, const T& b) {
  const T sum = a + b;
  return {sum, b - (sum - a)};
}

/// a + b exactly.
template <Lanes T>
Twofold<T> exact_sum(const T& a, const T& b) {
  const T sum = a + b;
  const T b_in_sum = sum - a;
  return {sum, (a - (sum - b_in_sum)) + (b - b_in_sum)};
}

/// x = hi + lo exactly, hi the upper half of the significand (26 or 12 bits), so that products of halves are exact.
/// Cut off rather than rounded (Veltkamp): a bit mask is one operation, and does not overflow.
template <Lanes T>
Twofold<T> halves(const T& x) {
  constexpr int low_bits = (fraction_bits<RealOf<T>> + 2) / 2; // 27 of 53, 12 of 24
  const T hi = from_bits<T>(bits_of(x) & ~((BitsOf<RealOf<T>>(1) << low_bits) - 1));
  return {hi, x - hi};
}

/// a b, with an error below 2^-(2 digits - 1) |a b|: the product of the two lower halves may need one bit too many.
template <Lanes T>
Twofold<T> wide_product(const T& a, const T& b) {
  const T product = a * b;
  const Twofold<T> x = halves(a), y = halves(b);
  return {product, ((x.hi * y.hi - product) + x.hi * y.lo + x.lo * y.hi) + x.lo * y.lo};
}

/// a b to about twice the precision.
template <Lanes T>
Twofold<T> wide_product(const Twofold<T>& a, const Twofold<T>& b) {
  const Twofold<T> product = wide_product(a.hi, b.hi);
  return quick_sum(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}

/// A constant of twice the precision.
template <class T>
Twofold<T> as(const Twofold<double>& constant) {
  return {as<T>(constant.hi), as<T>(constant.lo)};
}

} // namespace refraster
