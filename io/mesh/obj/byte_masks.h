#pragma once
// Which of 16 characters are a given one: a text is searched in steps of 16.

#if defined(__aarch64__)
#include <arm_neon.h>
#endif

#include <bit>
#include <cstdint>
#include <cstring>

namespace refraster {

class SixteenBytes {
public:
  explicit SixteenBytes(const char* at) { std::memcpy(&bytes_, at, sizeof bytes_); }

  /// Bit i is set where character i is `c`.
  std::uint32_t are(char c) const {
    const Bytes equal = bytes_ == c;
#ifdef __SSE2__
    return static_cast<std::uint32_t>(__builtin_ia32_pmovmskb128(equal));
#elif defined(__aarch64__)
    constexpr std::uint8_t places[] = {1, 2, 4, 8, 16, 32, 64, 128, 1, 2, 4, 8, 16, 32, 64, 128};
    const uint8x16_t bits = vandq_u8(std::bit_cast<uint8x16_t>(equal), vld1q_u8(places));
    return vaddv_u8(vget_low_u8(bits)) | static_cast<std::uint32_t>(vaddv_u8(vget_high_u8(bits))) << 8;
#else
    std::uint32_t set = 0;
    for (int i = 0; i < 16; ++i) set |= static_cast<std::uint32_t>(equal[i] & 1) << i;
    return set;
#endif
  }

private:
  using Bytes [[gnu::vector_size(16)]] = char;
  Bytes bytes_;
};

} // namespace refraster
