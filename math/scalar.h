#pragma once
// The Number operations for float and double, and the meaning that every other number type must agree with.

#include "math/kit_namespace.h"

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace refraster::inline REFRASTER_KIT {

/// What a number type has to say about itself. Specialised beside each number type; docs/number.md has an example.
///   Real       the floating-point type in which parameters and tables enter a formula; of lanes, that of one lane
///   TableReal  only where measured tables are stored in another type than Real: see TableRealOf
///   Mask       what a comparison gives
///   Index      integers made from numbers, for reading grids; 32 bits a lane
///   lanes      how many independent numbers one T holds
///   has_lanes  T is a register of lanes: a formula may treat all of them at once where they agree
///   decides    a comparison says yes or no, lane by lane, so that a formula may choose between two ways to a result by
///              any(mask). A bounds number, whose answer may be "perhaps", does not: it takes select
///   is_ieee    each lane is an IEEE 754 number, with its format, its range and its bits
///   largest    magnitudes above this overflow, as a double; DBL_MAX where there is no such limit within double
template <class T>
struct NumberTraits;

template <class T>
using RealOf = typename NumberTraits<T>::Real;
template <class T>
using MaskOf = typename NumberTraits<T>::Mask;
template <class T>
using IndexOf = typename NumberTraits<T>::Index;

namespace scalar_detail {
template <class T>
struct TableReal {
  using type = RealOf<T>;
};
template <class T>
  requires requires {
    typename NumberTraits<T>::TableReal;
  }
struct TableReal<T> {
  using type = typename NumberTraits<T>::TableReal;
};
} // namespace scalar_detail

/// What measured tables are stored in that are read for T: double, float or Half (math/half.h).
template <class T>
using TableRealOf = typename scalar_detail::TableReal<T>::type;

/// The greatest integer not above x, and how far x is beyond it, in [0, 1): the largest number below 1 where that
/// difference rounds to 1. Of a place in a grid: the cell, and the place in it.
template <class T>
struct Cell {
  IndexOf<T> index;
  T fraction;
};

/// The integer that has as many bits as F, for taking a number apart.
template <class F>
using BitsOf = std::conditional_t<sizeof(F) == 4, std::int32_t, std::int64_t>;

static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<float>::is_iec559);
static_assert(std::endian::native == std::endian::little, "lanes, files and hashes are read as bytes in this order");

template <std::floating_point F>
struct NumberTraits<F> {
  using Real = F;
  using Mask = bool;
  using Index = std::int32_t;
  static constexpr int lanes = 1;
  static constexpr bool has_lanes = false, decides = true, is_ieee = true;
  static constexpr double largest = static_cast<double>(std::numeric_limits<F>::max());
};

/// The largest finite number of T.
template <class T>
T largest_number() {
  return T(static_cast<RealOf<T>>(NumberTraits<T>::largest));
}

/// The smallest normal number of T, below which divisors do not go.
template <class T>
T smallest_normal() {
  if constexpr (requires { NumberTraits<T>::smallest_normal(); }) return NumberTraits<T>::smallest_normal();
  else return T(std::numeric_limits<RealOf<T>>::min());
}

template <std::floating_point F>
constexpr F select(bool m, F x, F y) {
  return m ? x : y;
}
template <std::floating_point F>
constexpr F max(F x, F y) {
  return x > y ? x : y;
}
template <std::floating_point F>
constexpr F min(F x, F y) {
  return x < y ? x : y;
}
template <std::floating_point F>
constexpr F square(F x) {
  return x * x;
}
template <std::floating_point F>
constexpr F abs(F x) {
  constexpr BitsOf<F> without_sign = std::numeric_limits<BitsOf<F>>::max();
  return std::bit_cast<F>(std::bit_cast<BitsOf<F>>(x) & without_sign);
}
template <std::floating_point F>
F sqrt(F x) {
  return std::sqrt(x); // correctly rounded by IEEE 754: one instruction, the same on every machine
}

#if defined(__FMA__) || defined(__aarch64__)
/// a b - c, rounded once: only where the machine has it.
template <std::floating_point F>
F fused_difference(F a, F b, F c) {
  return std::fma(a, b, -c);
}
#endif

/// Number of explicit fraction bits: 23 and 52.
template <class F>
inline constexpr int fraction_bits = std::numeric_limits<F>::digits - 1;

/// A power of two s with s |x| in [1, 2) for normal |x| up to 2^(max_exponent - 2).
/// For zero, subnormal, huge and non-finite x: the nearest power of two that is itself normal, so that s x never
/// overflows and s x == 0 exactly when x == 0. Multiplying by s is exact: lengths are scaled with it before they are
/// squared, so that (1e30, 0, 0) and (1e-30, 0, 0) have a length in every precision.
template <std::floating_point F>
constexpr F reciprocal_binade(F x) {
  using B = BitsOf<F>;
  constexpr B bias = std::numeric_limits<F>::max_exponent - 1;
  constexpr B exponent_mask = (2 * bias + 1) << fraction_bits<F>;
  constexpr F smallest = std::numeric_limits<F>::min();
  const F binade = std::bit_cast<F>(std::bit_cast<B>(x) & exponent_mask); // |x| with fraction 0; infinity for NaN
  const F inside = min(max(binade, smallest), 1 / smallest);
  return std::bit_cast<F>((2 * bias << fraction_bits<F>)-std::bit_cast<B>(inside)); // its exponent, negated
}

template <class F>
inline constexpr F almost_one = 1 - std::numeric_limits<F>::epsilon() / 2;

/// 1 / s for a power of two s as reciprocal_binade makes them: exact, and no division.
template <std::floating_point F>
constexpr F exact_reciprocal(F s) {
  using B = BitsOf<F>;
  constexpr B one_squared = B(2 * (std::numeric_limits<F>::max_exponent - 1)) << fraction_bits<F>;
  return std::bit_cast<F>(one_squared - std::bit_cast<B>(s));
}

/// Coordinates beyond this many cells are clamped to it, so that the index fits 32 bits; NaN counts as the lower
/// end.
inline constexpr double cell_limit = 1 << 30;

template <std::floating_point F>
Cell<F> floor_and_fraction(F x) {
  const F limit = static_cast<F>(cell_limit);
  const F inside = min(max(x, -limit), limit);
  // Truncate, then step down where that went up: lanes can do that too. For -0 compilers disagree whether the way over
  // the integer drops the sign, so the fraction's zero is made +0.
  const F truncated = static_cast<F>(static_cast<std::int32_t>(inside));
  const F below = truncated > inside ? truncated - 1 : truncated;
  return {static_cast<std::int32_t>(below), min(max(inside - below, F(0)), almost_one<F>)};
}

template <std::floating_point F>
constexpr F fraction(F x) {
  return floor_and_fraction(x).fraction;
}

constexpr std::int32_t clamp_index(std::int32_t i, std::int32_t lo, std::int32_t hi) {
  return i < lo ? lo : i > hi ? hi : i;
}
constexpr std::int32_t wrap_index(std::int32_t i, std::int32_t n) {
  const std::int32_t remainder = i % n;
  return remainder < 0 ? remainder + n : remainder;
}
constexpr std::int32_t next_index(std::int32_t i) {
  return i + 1;
}

// Masks answer these two questions; what a mask of lanes answers differs from lane to lane.
constexpr int count_lanes(bool m) {
  return m ? 1 : 0;
}
constexpr bool any(bool m) {
  return m;
}

} // namespace refraster::inline REFRASTER_KIT
