#pragma once
// Cosines to a whole power, by squaring: for a glossiness of 32 a quarter of the operations of a logarithm and an
// exponential, and as exact as these.

#include "math/elementary/exp_log.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <tuple>

namespace refraster::inline REFRASTER_KIT {

/// Raises numbers to the power n >= 1, all of them together: square() from the highest bit of n down, and multiply(),
/// by what they were at first, for each further bit that is set.
template <class Square, class Multiply>
void by_squaring(std::uint32_t n, const Square& square, const Multiply& multiply) {
  for (std::uint32_t bit = std::bit_floor(n) >> 1; bit != 0; bit >>= 1) {
    square();
    if ((n & bit) != 0) multiply();
  }
}

/// (hi + lo)^n for double lanes, where 0 < hi <= 1, |lo| <= u hi, u = 2^-53, and hi^n is normal. Relative error of a
/// result from min_two_product on: whole_power_error; below 2 n u.
///
/// Why so little. Each step keeps the error of its product and what lo makes of it, and neglects lo^2, or the product
/// of both lo, and the roundings of lo. |lo| <= 2 m u hi of a power m: each square doubles what lo is of hi, and adds a
/// rounding. So a square that makes the power m neglects m^2 u^2 + 4 m u^2 of it at most, a product less than 6 m u^2,
/// and from there it grows by n / m: all squares together (1 + 1/2 + 1/4 ...) n^2 u^2 + 4 n log2(n) u^2, all products 6
/// n log2(n) u^2. The sum of hi and lo is the only rounding that shows. Where products are too small to know their
/// errors, lo is left out, and hi alone is off by 2 n u.
///
/// N at once, since the steps of one wait for each other. In place, and hi apart from lo: GCC 12 copies an array of
/// pairs through memory.
template <std::size_t N, Lanes T>
  requires(sizeof(RealOf<T>) == 8)
void raise_to_whole_power(T (&hi)[N], T (&lo)[N], std::uint32_t n) {
  T base_hi[N], base_lo[N];
  for (std::size_t i = 0; i < N; ++i) base_hi[i] = hi[i], base_lo[i] = lo[i];
  const auto square = [&] {
    for (std::size_t i = 0; i < N; ++i) {
      const T product = hi[i] * hi[i];
      lo[i] = (hi[i] + hi[i]) * lo[i] + product_error(hi[i], hi[i], product);
      hi[i] = product;
    }
  };
  const auto multiply = [&] {
    for (std::size_t i = 0; i < N; ++i) {
      const T product = hi[i] * base_hi[i];
      lo[i] = (hi[i] * base_lo[i] + lo[i] * base_hi[i]) + product_error(hi[i], base_hi[i], product);
      hi[i] = product;
    }
  };
  by_squaring(n, square, multiply);
  for (std::size_t i = 0; i < N; ++i) hi[i] = hi[i] + select(hi[i] >= as<T>(min_two_product<double>), lo[i], T(0));
}

/// a = (a - b)^n, and at least least^n, for float lanes, where a - b <= 1. In double, where n roundings of the
/// difference and n - 1 of products are 2 n 2^-53: rounding the result to float is nearly the only error.
template <std::size_t N, Lanes T>
  requires(sizeof(RealOf<T>) == 4)
void raise_to_whole_power(T (&a)[N], const T (&b)[N], double least, std::uint32_t n) {
  using Wide = decltype(widened(a[0]));
  using D = typename Wide::value_type;
  constexpr std::size_t registers = std::tuple_size_v<Wide>;
  D x[N * registers], base[N * registers];
  for (std::size_t i = 0; i < N; ++i) {
    const Wide wide_a = widened(a[i]), wide_b = widened(b[i]);
    for (std::size_t k = 0; k < registers; ++k)
      base[i * registers + k] = x[i * registers + k] = max(wide_a[k] - wide_b[k], D(least));
  }
  const auto square = [&] {
    for (D& y : x) y = y * y;
  };
  const auto multiply = [&] {
    for (std::size_t k = 0; k < N * registers; ++k) x[k] = x[k] * base[k];
  };
  by_squaring(n, square, multiply);
  for (std::size_t i = 0; i < N; ++i) {
    Wide power;
    for (std::size_t k = 0; k < registers; ++k) power[k] = x[i * registers + k];
    a[i] = narrowed<T>(power);
  }
}

/// The relative error of raise_to_whole_power(…, n), in units of u = epsilon / 2, of results from
/// min_two_product<double> on.
template <class F>
constexpr double whole_power_error(std::uint32_t n) {
  const double squared = static_cast<double>(n) * n, products = 10.0 * n * std::bit_width(n);
  return 1 + (sizeof(F) == 4 ? 2.0 * n * 0x1p-29 : (2 * squared + products) * 0x1p-53);
}

} // namespace refraster::inline REFRASTER_KIT
