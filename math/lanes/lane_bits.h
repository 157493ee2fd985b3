#pragma once
// Taking numbers apart, written once for a plain float or double and for lanes of either.

#include "math/lanes/wide.h"

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

/// f(x...) computed in double: float lanes are widened (exactly), the result is rounded once. As many double lanes at
/// a time as a register holds.
template <class Function>
float in_double(const Function& f, std::same_as<float> auto... x) {
  return static_cast<float>(f(static_cast<double>(x)...));
}

template <class Function, int N, class... More>
Wide<float, N> in_double(const Function& f, const Wide<float, N>& x, const More&... more) {
  if constexpr (N > 2 && N * static_cast<int>(sizeof(double)) > native_vector_bytes) {
    return joined(in_double(f, low_half(x), low_half(more)...), in_double(f, high_half(x), high_half(more)...));
  } else {
    const auto widened = [](const Wide<float, N>& y) {
      if constexpr (requires { registers::widened(y.v); })
        return Wide<double, N>(VectorOf<double, N>(registers::widened(y.v)));
      else return Wide<double, N>(__builtin_convertvector(y.v, VectorOf<double, N>));
    };
    return __builtin_convertvector(f(widened(x), widened(more)...).v, VectorOf<float, N>);
  }
}

} // namespace refraster::inline REFRASTER_KIT
