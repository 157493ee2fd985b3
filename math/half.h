#pragma once
// IEEE half precision, for storage only: tables of half the size of float.

#include "math/lanes/rows.h"

namespace refraster { // not the kit's: tables of it are the library's

/// 1 sign, 5 exponent and 10 fraction bits. Finite. Numbers become halves by half_of (math/half_of.h).
struct Half {
  std::uint16_t bits = 0;

  static constexpr double largest = 65504;

  /// Exact.
  explicit constexpr operator float() const {
    // The fraction and exponent in a float's places make a number 2^112 times too small, also where it is subnormal.
    const float size = std::bit_cast<float>((bits & 0x7fff) << 13) * 0x1p112f;
    return bits & 0x8000 ? -size : size;
  }
};

} // namespace refraster

namespace refraster::inline REFRASTER_KIT {

template <int N>
using HalfLanes = VectorOf<std::uint16_t, N>;

namespace half_detail {

/// The same for lanes that hold the bits of a half.
template <int N>
Wide<float, N> plain_widened(HalfLanes<N> halves) {
  using Ints = VectorOf<std::int32_t, N>;
  const Ints bits = __builtin_convertvector(halves, Ints);
  const Wide<float, N> size = from_bits<float, N>((bits & 0x7fff) << 13) * Wide<float, N>(0x1p112f);
  return from_bits<float, N>(bits_of(size) | ((bits & 0x8000) << 16));
}

} // namespace half_detail

/// The numbers that these bits stand for: exact, and the same bits with and without the instruction for it.
template <int N>
Wide<float, N> widened(HalfLanes<N> halves) {
#if defined(__AVX512F__)
  if constexpr (N == 16) return VectorOf<float, N>(_mm512_maskz_cvtph_ps(0xFFFF, __m256i(halves)));
#endif
#if defined(__F16C__)
  if constexpr (N == 8) return VectorOf<float, N>(_mm256_cvtph_ps(__m128i(halves)));
  if constexpr (N == 4) {
    const VectorOf<std::uint16_t, 8> in_register = __builtin_shufflevector(halves, halves, 0, 1, 2, 3, 0, 1, 2, 3);
    return VectorOf<float, N>(_mm_cvtph_ps(__m128i(in_register)));
  }
#endif
  return half_detail::plain_widened<N>(halves);
}

/// gather_rows of four halves each, as floats.
template <std::same_as<Half> F, int N, class Place>
std::array<Wide<float, N>, 4> gather_rows(const Place& at) {
  const auto row = [&](int lane) {
    std::uint64_t halves;
    std::memcpy(&halves, at(lane), sizeof halves);
    return halves;
  };
  // group(k) holds the rows of lanes k, k + 4, k + 8 …, so that the lanes come out in order.
  const auto group = [&](int k) {
    return [&]<int... I>(std::integer_sequence<int, I...>) {
      const VectorOf<std::uint64_t, N / 4> rows{row(k + 4 * I)...};
      return widened<N>(reinterpret_cast<HalfLanes<N>>(rows));
    }
    (std::make_integer_sequence<int, N / 4>{});
  };
  static_assert(N % 4 == 0);
  return transposed<float, N>({group(0), group(1), group(2), group(3)});
}

} // namespace refraster::inline REFRASTER_KIT
