#pragma once
// Small things about registers of samples or triangles that set-up, binning and tiles share.

#include "math/lanes/rows.h"
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

/// Two doubles that stand side by side at place(lane), for each lane.
template <int N>
std::array<Wide<double, N>, 2> gather_pairs(const auto& place) {
  static_assert(N <= 8);
  using Pair = Wide<double, 2>;
  const auto load = [&](int lane) {
    Pair x;
    std::memcpy(&x, place(lane), sizeof x);
    return x;
  };
  // Lanes 0, 2, 4 … and 1, 3, 5 … side by side.
  const auto every_second = [&](int first) {
    if constexpr (N == 2) return load(first);
    else if constexpr (N == 4) return joined(load(first), load(first + 2));
    else return joined(joined(load(first), load(first + 2)), joined(load(first + 4), load(first + 6)));
  };
  const Wide<double, N> even = every_second(0), odd = every_second(1);
  return [&]<int... I>(std::integer_sequence<int, I...>) {
    return std::array<Wide<double, N>, 2>{__builtin_shufflevector(even.v, odd.v, (I % 2 * N + I / 2 * 2)...),
                                          __builtin_shufflevector(even.v, odd.v, (I % 2 * N + I / 2 * 2 + 1)...)};
  }
  (std::make_integer_sequence<int, N>{});
}

/// A double that stands at place(lane), for each lane; of any type that has so many bytes.
template <int N>
Wide<double, N> gather_doubles(const auto& place) {
  const auto load = [&](int lane) {
    double x;
    std::memcpy(&x, place(lane), sizeof x);
    return x;
  };
  return [&]<int... lane>(std::integer_sequence<int, lane...>) {
    return Wide<double, N>(VectorOf<double, N>{load(lane)...});
  }
  (std::make_integer_sequence<int, N>{});
}

/// Two integers of 32 bits in the bits of each double: those of N lanes, of one register or two.
template <int N, std::size_t parts>
void part_words(const std::array<Wide<double, N / static_cast<int>(parts)>, parts>& pairs,
                VectorOf<std::int32_t, N>& low, VectorOf<std::int32_t, N>& high) {
  using Words = VectorOf<std::int32_t, 2 * N / static_cast<int>(parts)>;
  const auto words = [&](std::size_t part) { return std::bit_cast<Words>(pairs[part].v); };
  [&]<int... I>(std::integer_sequence<int, I...>) {
    low = __builtin_shufflevector(words(0), words(parts - 1), (2 * I)...);
    high = __builtin_shufflevector(words(0), words(parts - 1), (2 * I + 1)...);
  }
  (std::make_integer_sequence<int, N>{});
}

/// Three floats that stand side by side at place(lane), for each lane. Nothing beyond them is read.
template <int N>
std::array<Wide<float, N>, 3> gather_triples(const auto& place) {
  const auto row = [&](int lane) {
    const float* const at = place(lane);
#if defined(__AVX512VL__)
    return Wide<float, 4>(VectorOf<float, 4>(_mm_maskz_loadu_ps(7, at)));
#elif defined(__AVX__)
    return Wide<float, 4>(VectorOf<float, 4>(_mm_maskload_ps(at, _mm_setr_epi32(-1, -1, -1, 0))));
#else
    return Wide<float, 4>(VectorOf<float, 4>{at[0], at[1], at[2]});
#endif
  };
  // Group k takes the rows of lanes k, k + 4, k + 8 …, so that the lanes come out in order.
  const auto group = [&](int k) {
    if constexpr (N <= 4) return row(k);
    else if constexpr (N == 8) return joined(row(k), row(k + 4));
    else return joined(joined(row(k), row(k + 4)), joined(row(k + 8), row(k + 12)));
  };
  static_assert(N == 2 || N == 4 || N == 8 || N == 16);
  if constexpr (N == 2) {
    const Wide<float, 4> a = row(0), b = row(1);
    return {VectorOf<float, 2>{a[0], b[0]}, VectorOf<float, 2>{a[1], b[1]}, VectorOf<float, 2>{a[2], b[2]}};
  } else {
    const std::array<Wide<float, N>, 4> x = transposed<float, N>({group(0), group(1), group(2), group(3)});
    return {x[0], x[1], x[2]};
  }
}

/// The lanes in which an integer is negative, as true is: a bit for each, lane 0 the lowest.
template <class Ints>
std::uint32_t negative_lanes(const Ints& x) {
  constexpr int lanes = sizeof(Ints) / sizeof(std::int32_t);
  using Floats = VectorOf<float, lanes>;
#if defined(__AVX512DQ__)
  if constexpr (lanes == 16) return _mm512_movepi32_mask(std::bit_cast<__m512i>(x));
  else
#endif
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
