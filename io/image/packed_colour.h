#pragma once
// Channels that share a number of 16 or 32 bits.

#include <algorithm>
#include <bit>
#include <cstdint>

namespace refraster {

/// Whether the ones of a mask stand side by side; a mask of 0 has none.
constexpr bool is_contiguous(std::uint32_t mask) {
  const std::uint64_t shifted = mask == 0 ? 0 : std::uint64_t{mask} >> std::countr_zero(mask);
  return (shifted & (shifted + 1)) == 0;
}

/// The channel under a contiguous mask, brought from 0..its largest to 0..full_scale: the nearest whole number.
/// (Copying the upper bits into the lower ones, as is often done, is one off for some.) 0 under a mask of 0.
constexpr float channel_of(std::uint32_t packed, std::uint32_t mask, std::uint32_t full_scale) {
  if (mask == 0) return 0;
  const int shift = std::countr_zero(mask);
  const std::uint64_t largest = mask >> shift, value = (packed & mask) >> shift;
  return static_cast<float>((value * full_scale + largest / 2) / largest);
}

} // namespace refraster
