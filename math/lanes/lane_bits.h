#pragma once
// Taking numbers apart, written once for a plain float or double and for lanes of either.

#include "math/lanes/wide.h"

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace refraster::inline REFRASTER_KIT {

template <class T>
struct LaneBitsOf;
template <std::floating_point F>
struct LaneBitsOf<F> {
  using type = BitsOf<F>;
  using unsigned_type = std::make_unsigned_t<BitsOf<F>>;
};
template <class F, int N, Arithmetic A>
struct LaneBitsOf<Wide<F, N, A>> {
  using type = VectorOf<BitsOf<F>, N>;
  using unsigned_type = VectorOf<std::make_unsigned_t<BitsOf<F>>, N>;
};

/// A plain number or lanes of one: what the elementary functions are written for. Bounds types bring their own.
template <class T>
concept Lanes = requires {
  typename LaneBitsOf<T>::type;
};

/// The integers that hold the bits of T: one a lane, as wide as the lane.
template <Lanes T>
using LaneBits = typename LaneBitsOf<T>::type;

template <std::floating_point F>
constexpr BitsOf<F> bits_of(F x) {
  return std::bit_cast<BitsOf<F>>(x);
}
template <Lanes T>
T from_bits(LaneBits<T> bits) {
  return std::bit_cast<T>(bits);
}

/// The same, unsigned: what a lane holds where its result will not be used may overflow, and must be allowed to.
template <Lanes T>
using UnsignedLaneBits = typename LaneBitsOf<T>::unsigned_type;

/// bits >> count, zeros coming in from the left: SSE2 and AVX2 have no arithmetic shift of 64-bit lanes.
template <Lanes T>
LaneBits<T> shift_right(LaneBits<T> bits, int count) {
  return std::bit_cast<LaneBits<T>>(std::bit_cast<UnsignedLaneBits<T>>(bits) >> count);
}

/// Bits of the constant 1 and of any other constant of the lane type, as a plain integer.
template <class T>
inline constexpr BitsOf<RealOf<T>> one_bits = std::bit_cast<BitsOf<RealOf<T>>>(RealOf<T>(1));

/// 2^fraction_bits: adding it to a small integer n >= 0 puts n into the lowest bits. Conversion between integers and
/// numbers goes this way because 64-bit lanes have no instruction for it before AVX-512.
template <class T>
inline constexpr RealOf<T> integer_rounding_bias = RealOf<T>(BitsOf<RealOf<T>>(1) << fraction_bits<RealOf<T>>);

/// n + offset as a number, for 0 <= n < 2^fraction_bits.
template <Lanes T>
T to_number(LaneBits<T> n, BitsOf<RealOf<T>> offset) {
  const RealOf<T> bias = integer_rounding_bias<T> - static_cast<RealOf<T>>(offset);
  return from_bits<T>(n | std::bit_cast<BitsOf<RealOf<T>>>(integer_rounding_bias<T>)) - T(bias);
}

/// x with the sign bit of y wherever that is set, for x >= 0.
template <Lanes T>
T with_sign(const T& x, const T& y) {
  constexpr BitsOf<RealOf<T>> sign = std::numeric_limits<BitsOf<RealOf<T>>>::min();
  return from_bits<T>(bits_of(x) | (bits_of(y) & sign));
}

/// Float lanes in double, exactly: as many registers as that takes.
inline std::array<double, 1> widened(float x) {
  return {static_cast<double>(x)};
}
template <int N, Arithmetic A>
auto widened(const Wide<float, N, A>& x) {
  if constexpr (N > 2 && N * static_cast<int>(sizeof(double)) > native_vector_bytes) {
    const auto low = widened(low_half(x)), high = widened(high_half(x));
    return [&]<std::size_t... I>(std::index_sequence<I...>) {
      return std::array{low[I]..., high[I]...};
    }
    (std::make_index_sequence<low.size()>{});
  } else if constexpr (requires { registers::widened(x.v); }) {
    return std::array{Wide<double, N>(VectorOf<double, N>(registers::widened(x.v)))};
  } else {
    return std::array{Wide<double, N>(__builtin_convertvector(x.v, VectorOf<double, N>))};
  }
}

/// And back, rounded once.
template <std::same_as<float>>
float narrowed(const std::array<double, 1>& x) {
  return static_cast<float>(x[0]);
}
template <class T, int N, std::size_t registers>
  requires(NumberTraits<T>::lanes == static_cast<int>(registers) * N)
T narrowed(const std::array<Wide<double, N>, registers>& x) {
  if constexpr (registers == 1) {
    return T(__builtin_convertvector(x[0].v, VectorOf<float, N>));
  } else {
    using Half = std::remove_cvref_t<decltype(low_half(std::declval<T>()))>;
    const auto half = [&]<std::size_t... I>(std::size_t first, std::index_sequence<I...>) {
      return narrowed<Half>(std::array{x[first + I]...});
    };
    constexpr std::make_index_sequence<registers / 2> each_half{};
    return joined(half(0, each_half), half(registers / 2, each_half));
  }
}

/// f(x...) computed in double: float lanes are widened, the result is rounded once. As many double lanes at a time as a
/// register holds.
template <class Function, class T, std::same_as<T>... More>
T in_double(const Function& f, const T& x, const More&... more) {
  const auto wide = widened(x);
  return [&]<std::size_t... I>(std::index_sequence<I...>, const auto&... others) {
    return narrowed<T>(std::array{[&](std::size_t i) { return f(wide[i], others[i]...); }(I)...});
  }
  (std::make_index_sequence<wide.size()>{}, widened(more)...);
}

} // namespace refraster::inline REFRASTER_KIT
