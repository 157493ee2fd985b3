#pragma once
// Small things about registers of samples or triangles that set-up, binning and tiles share.

#include "math/precisions.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <utility>

namespace refraster {

/// 0, 1, 2 …
template <class F, int N>
Wide<F, N> lane_numbers() {
  return [&]<int... lane>(std::integer_sequence<int, lane...>) {
    return Wide<F, N>(VectorOf<F, N>{F(lane)...});
  }
  (std::make_integer_sequence<int, N>{});
}

template <int N>
VectorOf<std::int32_t, N> int_lane_numbers() {
  return [&]<int... lane>(std::integer_sequence<int, lane...>) {
    return VectorOf<std::int32_t, N>{lane...};
  }
  (std::make_integer_sequence<int, N>{});
}

/// Whole numbers under 2^31 as integers: fractions are cut off. And back.
template <int N>
VectorOf<std::int32_t, N> integers(const Wide<double, N>& x) {
  return __builtin_convertvector(x.v, VectorOf<std::int32_t, N>);
}
template <int N>
Wide<double, N> numbers(const VectorOf<std::int32_t, N>& x) {
  return __builtin_convertvector(x, VectorOf<double, N>);
}

/// The lesser and the greater of two integers in each lane.
template <class Ints>
Ints lesser(const Ints& x, const Ints& y) {
  return x < y ? x : y;
}
template <class Ints>
Ints greater(const Ints& x, const Ints& y) {
  return x > y ? x : y;
}

/// A register as an array: its lanes are read one by one from memory.
template <class F, int N>
std::array<F, N> listed(const Wide<F, N>& x) {
  return std::bit_cast<std::array<F, N>>(x.v);
}

/// The lanes in which an integer is negative, as true is: a bit for each, lane 0 the lowest.
template <class Ints>
std::uint32_t negative_lanes(const Ints& x) {
  constexpr int lanes = sizeof(Ints) / sizeof(std::int32_t);
  using Floats = VectorOf<float, lanes>;
  if constexpr (requires(Floats v) { registers::sign_bits(v); }) {
    return registers::sign_bits(std::bit_cast<Floats>(x));
  } else {
    std::uint32_t set = 0;
    for (int lane = 0; lane < lanes; ++lane) set |= (x[lane] < 0 ? 1u : 0u) << lane;
    return set;
  }
}

template <class Lanes>
Lanes load_lanes(const void* at) {
  Lanes x;
  std::memcpy(&x, at, sizeof x);
  return x;
}
template <class Lanes>
void store_lanes(void* at, const Lanes& x) {
  std::memcpy(at, &x, sizeof x);
}

} // namespace refraster
