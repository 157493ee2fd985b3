#pragma once
// Numbers of twice the precision: an unevaluated sum hi + lo with |lo| <= ulp(hi) / 2. Dekker, "A floating-point
// technique for extending the available precision", 1971.

#include "math/lanes/lane_bits.h"

namespace refraster::inline REFRASTER_KIT {

template <class T>
struct DoubleDouble {
  T hi, lo;
};

/// a + b exactly, for |a| >= |b| or a and b of one binade, or a = 0.
template <Lanes T>
DoubleDouble<T> fast_two_sum(const T& a, const T& b) {
  const T sum = a + b;
  return {sum, b - (sum - a)};
}

/// a + b exactly.
template <Lanes T>
DoubleDouble<T> two_sum(const T& a, const T& b) {
  const T sum = a + b;
  const T b_in_sum = sum - a;
  return {sum, (a - (sum - b_in_sum)) + (b - b_in_sum)};
}

/// x = hi + lo exactly: hi is x rounded to the upper half of the significand (26 or 12 bits), and lo needs no more, so
/// that products of halves are exact. Rounded by adding to the bits, which does not overflow before x does.
template <Lanes T>
DoubleDouble<T> veltkamp_split(const T& x) {
  constexpr int low_bits = (fraction_bits<RealOf<T>> + 2) / 2; // 27 of 53, 12 of 24
  constexpr BitsOf<RealOf<T>> half = BitsOf<RealOf<T>>(1) << (low_bits - 1);
  const UnsignedLaneBits<T> raised = std::bit_cast<UnsignedLaneBits<T>>(x) + half;
  const T hi = from_bits<T>(std::bit_cast<LaneBits<T>>(raised) & ~(2 * half - 1));
  return {hi, x - hi};
}

/// Below this a product counts as exact: its error could be subnormal, and then be rounded itself.
template <class F>
inline constexpr double min_two_product = sizeof(F) == 4 ? 0x1p-100 : 0x1p-960;

/// a b - product exactly, where `product` is a b rounded, and not smaller than min_two_product. A fused multiply-add
/// gives the same as Dekker's sum of partial products, since both are exact: so here, where it saves a dozen
/// operations, it changes no bit.
template <Lanes T>
T product_error(const T& a, const T& b, const T& product) {
  if constexpr (requires { fused_difference(a, b, product); }) {
    return fused_difference(a, b, product);
  } else {
    const DoubleDouble<T> x = veltkamp_split(a), y = veltkamp_split(b);
    return ((x.hi * y.hi - product) + x.hi * y.lo + x.lo * y.hi) + x.lo * y.lo;
  }
}

/// a b exactly; rounded where it is smaller than min_two_product.
template <Lanes T>
DoubleDouble<T> two_product(const T& a, const T& b) {
  const T product = a * b, error = product_error(a, b, product);
  return {product, select(abs(product) >= as<T>(min_two_product<RealOf<T>>), error, T(0))};
}

/// a b to about twice the precision.
template <Lanes T>
DoubleDouble<T> two_product(const DoubleDouble<T>& a, const DoubleDouble<T>& b) {
  const DoubleDouble<T> product = two_product(a.hi, b.hi);
  return fast_two_sum(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}

/// A constant of twice the precision.
template <class T>
DoubleDouble<T> as(const DoubleDouble<double>& constant) {
  return {as<T>(constant.hi), as<T>(constant.lo)};
}

} // namespace refraster::inline REFRASTER_KIT
