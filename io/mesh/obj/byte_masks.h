#pragma once
// Which of 16 characters are a given one: a text is searched in steps of 16.

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
