#pragma once

#include "math/number.h"

#include <array>
#include <bit>
#include <cstddef>

namespace refraster::inline REFRASTER_KIT {

/// x, x^2, x^4, ...
template <class T, std::size_t N>
std::array<T, N> repeated_squares(const T& x) {
  std::array<T, N> power{x};
  for (std::size_t i = 1; i < N; ++i) power[i] = power[i - 1] * power[i - 1];
  return power;
}

/// The coefficients [first, first + count) of a polynomial, as one of their own.
template <std::size_t first, std::size_t count, class T, std::size_t Squares, std::size_t N>
T part_of_polynomial(const std::array<T, Squares>& power, const std::array<double, N>& c) {
  if constexpr (count == 1) {
    return as<T>(c[first]);
  } else {
    constexpr std::size_t low = std::bit_floor(count - 1);
    return multiply_add(part_of_polynomial<first + low, count - low>(power, c), power[std::countr_zero(low)],
                        part_of_polynomial<first, low>(power, c));
  }
}

/// c[0] + c[1] x + c[2] x^2 + ..., by halves: the lower coefficients plus x^(2^k) times the upper ones (Estrin). That
/// is two or three multiplications more than Horner's rule, which on the other hand waits for each one before the next.
template <class T, std::size_t N>
T polynomial(const T& x, const std::array<double, N>& c) {
  return part_of_polynomial<0, N>(repeated_squares<T, std::bit_width(N - 1)>(x), c);
}

} // namespace refraster::inline REFRASTER_KIT
