#pragma once
// From colours to pixels of three bytes.

#include "math/elementary.h"
#include "math/lanes/wide.h"
#include "raster/lanes.h"
#include "shading/srgb_curve.h"

#include <refraster/render.h>

#include <cstdint>
#include <cstring>

namespace refraster {

/// 255 times x clamped to [0, 1], rounded to the nearest integer, half to even. For a number without lanes that a
/// double can be made of.
template <class T>
std::uint8_t level_of(const T& x, Transfer transfer) {
  const T in_range = min(max0(x), T(1));
  const Cell<T> at = floor_and_fraction((transfer == Transfer::srgb ? srgb_encoded(in_range) : in_range) * T(255));
  const bool up = at.fraction > T(0.5) || (!(at.fraction < T(0.5)) && at.index % 2 != 0);
  return static_cast<std::uint8_t>(at.index + (up ? 1 : 0));
}

/// 255 times x clamped to [0, 1], rounded to the nearest integer, half to even; 0 for NaN. Each lane of the result
/// holds that integer in its lowest bits.
template <Transfer transfer, class T>
auto level_bits(const T& x) {
  using Real = RealOf<T>;
  const T in_range = min(max0(x), T(1));
  T encoded = in_range;
  if constexpr (transfer == Transfer::srgb) encoded = srgb_encoded(in_range);
  const T scaled = encoded * T(255);
  // Adding 2^p, with p the number of fraction bits, leaves the rounded integer in the lowest bits.
  return bits_of(scaled + T(static_cast<Real>(BitsOf<Real>(1) << fraction_bits<Real>))) & 255;
}

/// Levels of red, green and blue in the lowest three bytes of each lane.
template <Transfer transfer, class T>
auto rgb8_words(const Rgb<T>& rgb) {
  return __builtin_convertvector(level_bits<transfer>(rgb.x) | level_bits<transfer>(rgb.y) << 8 |
                                     level_bits<transfer>(rgb.z) << 16,
                                 VectorOf<std::int32_t, NumberTraits<T>::lanes>);
}

/// Neighbouring pixels, from such words to bytes.
inline void store_rgb8(const std::int32_t* words, int pixels, std::uint8_t* to) {
  using Bytes = VectorOf<std::uint8_t, 16>;
  constexpr int at_once = 4;
  const auto packed = [&](int x) {
    const auto four = load_lanes<Bytes>(words + x);
    return __builtin_shufflevector(four, four, 0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, -1, -1, -1, -1);
  };
  int x = 0;
  // What is stored after four pixels is overwritten by the next four: and so not after the last ones, beside which
  // another thread may be writing.
  for (; x + 2 * at_once <= pixels; x += at_once) store_lanes(to + 3 * x, packed(x));
  if (x + at_once <= pixels) {
    const Bytes last = packed(x);
    std::memcpy(to + 3 * x, &last, 3 * at_once);
    x += at_once;
  }
  for (; x < pixels; ++x) std::memcpy(to + 3 * x, words + x, 3); // the lowest byte comes first
}

} // namespace refraster
