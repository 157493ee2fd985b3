#pragma once
// One number for the bits of many.

#include <bit>
#include <concepts>
#include <cstdint>
#include <type_traits>

namespace refraster {

/// Fowler, Noll and Vo's hash, FNV-1a with 64 bits, a byte at a time. A float counts as 64 bits, the upper ones its
/// sign.
class Checksum {
public:
  void add(std::floating_point auto x) {
    using Bits = std::conditional_t<sizeof x == 4, std::int32_t, std::int64_t>;
    const auto bits = static_cast<std::uint64_t>(std::bit_cast<Bits>(x));
    for (int shift = 0; shift < 64; shift += 8) value_ = (value_ ^ (bits >> shift & 0xFF)) * 0x100000001B3u;
  }
  std::uint64_t value() const { return value_; }

private:
  std::uint64_t value_ = 0xCBF29CE484222325u;
};

} // namespace refraster
