#pragma once
// The vocabulary of a formula. A fragment function is written once, over a Number T, and runs as
//   double          the reference          (math/scalar.h)
//   float           GPU-like arithmetic    (math/scalar.h)
//   Wide<F, N>      N lanes of either      (math/lanes/wide.h)
//   Exact           60 digits, the truth   (math/exact.h)
//   Interval        bounds, the proof      (math/bounds/interval.h)
// and as any number type of one's own that has them: docs/number.md.
// Only the operations below may be used on a Number, so that every one of these types can follow:
// there is no `if` on a value, and the mask of a bounds type has no conversion to bool.

#include "math/scalar.h"

#include <concepts>
#include <limits>

namespace refraster::inline REFRASTER_KIT {

/// Beside these, every Number has (each total, and of lanes branch-free and the same bits in a lane as alone):
///   exp2(x), log2(x), pow(x, s), atan2(y, x)       math/elementary.h; required by ElementaryNumber
///   cosine_power(a, b, s), length(a), normalize(a)   math/elementary/cosine_power.h, math/vec.h
///   read_grid(place, axes, read)                     math/read_grid.h
template <class T>
concept Number = requires(T x, T y, MaskOf<T> m, IndexOf<T> i) {
  typename NumberTraits<T>::Real;
  { NumberTraits<T>::lanes } -> std::convertible_to<int>;
  { NumberTraits<T>::has_lanes } -> std::convertible_to<bool>;
  { NumberTraits<T>::decides } -> std::convertible_to<bool>;
  { NumberTraits<T>::is_ieee } -> std::convertible_to<bool>;
  { NumberTraits<T>::largest } -> std::convertible_to<double>;
  T(0);
  { x + y } -> std::same_as<T>;
  { x - y } -> std::same_as<T>;
  { x* y } -> std::same_as<T>;
  { x / y } -> std::same_as<T>;
  { -x } -> std::same_as<T>;
  { x < y } -> std::same_as<MaskOf<T>>;
  { x > y } -> std::same_as<MaskOf<T>>;
  { x <= y } -> std::same_as<MaskOf<T>>;
  { x >= y } -> std::same_as<MaskOf<T>>;
  { select(m, x, y) } -> std::same_as<T>; // x where m, else y
  { max(x, y) } -> std::same_as<T>;       // y where either is NaN
  { min(x, y) } -> std::same_as<T>;       // y where either is NaN
  { abs(x) } -> std::same_as<T>;          // |x|
  { square(x) } -> std::same_as<T>;       // x x; a bounds type knows that it is not negative
  { sqrt(x) } -> std::same_as<T>;         // square root
  { m& m } -> std::convertible_to<MaskOf<T>>;
  { m | m } -> std::convertible_to<MaskOf<T>>;
  { !m } -> std::convertible_to<MaskOf<T>>;
  { any(m) } -> std::same_as<bool>;                     // whether it may be so, in any lane
  { count_lanes(m) } -> std::same_as<int>;              // in how many lanes it is certainly so
  { fraction(x) } -> std::same_as<T>;                   // x less the greatest integer not above it
  { clamp_index(i, 0, 1) } -> std::same_as<IndexOf<T>>; // into [lo, hi]
  { wrap_index(i, 1) } -> std::same_as<IndexOf<T>>;     // modulo n, into [0, n)
  { next_index(i) } -> std::same_as<IndexOf<T>>;        // i + 1
};

/// A parameter, which is always a double, enters a formula: rounded once to T's precision. A bounds number holds
/// whatever that may give.
template <class T>
constexpr T as(double parameter) {
  if constexpr (requires { NumberTraits<T>::parameter(parameter); }) return NumberTraits<T>::parameter(parameter);
  else return T(static_cast<RealOf<T>>(parameter));
}

/// A finite parameter as near as T comes to it: the largest number where it is beyond. Rounded by as<T> alone it
/// would be infinite, and an infinite light makes NaN where nothing of it is reflected.
template <class T>
constexpr double within_range(double parameter) {
  constexpr double largest = NumberTraits<T>::largest, largest_double = std::numeric_limits<double>::max();
  if (parameter > largest && parameter <= largest_double) return largest;
  if (parameter < -largest && parameter >= -largest_double) return -largest;
  return parameter;
}

/// Whether T trades last bits for speed; see math/lanes/wide.h.
template <class T>
inline constexpr bool is_fast = false;

/// a b + c; in one rounding where T is fast.
template <class T>
constexpr T multiply_add(const T& a, const T& b, const T& c) {
  return a * b + c;
}

/// <x> = max(x, 0); 0 for NaN.
template <class T>
constexpr T max0(const T& x) {
  return max(x, T(0));
}

} // namespace refraster::inline REFRASTER_KIT
