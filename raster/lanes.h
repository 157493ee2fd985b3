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
