#include "io/image/png/png_filter.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace refraster {
namespace {

// What a filter takes from a byte: of the bytes to the left, above, and above to the left. In the order of their
// numbers in the file. Portable Network Graphics, 9.2.

struct None {
  static std::uint8_t predict(std::uint8_t, std::uint8_t, std::uint8_t) { return 0; }
};
struct Sub {
  static std::uint8_t predict(std::uint8_t left, std::uint8_t, std::uint8_t) { return left; }
};
struct Up {
  static std::uint8_t predict(std::uint8_t, std::uint8_t above, std::uint8_t) { return above; }
};
struct Average {
  static std::uint8_t predict(std::uint8_t left, std::uint8_t above, std::uint8_t) {
    return static_cast<std::uint8_t>((left + above) / 2);
  }
};
/// Of the three, the one that is nearest to left + above - corner; ties go to the left, then above. In 16 bits and
/// without a branch, so that a compiler puts it into lanes.
struct Paeth {
  static std::uint8_t predict(std::uint8_t left, std::uint8_t above, std::uint8_t corner) {
    const auto to_left = static_cast<std::int16_t>(above - corner), to_above = static_cast<std::int16_t>(left - corner);
    const auto sum = static_cast<std::int16_t>(to_left + to_above);
    const auto far_left = static_cast<std::int16_t>(to_left < 0 ? -to_left : to_left);
    const auto far_above = static_cast<std::int16_t>(to_above < 0 ? -to_above : to_above);
    const auto far_corner = static_cast<std::int16_t>(sum < 0 ? -sum : sum);
    const std::uint8_t vertical = far_above <= far_corner ? above : corner;
    return far_left <= far_above && far_left <= far_corner ? left : vertical;
  }
};

/// What stands to the left of the first pixel is 0.
template <class Filter>
void apply(const std::uint8_t* __restrict row, const std::uint8_t* __restrict above, std::size_t row_bytes,
           std::size_t pixel_bytes, std::uint8_t* __restrict to) {
  const std::size_t first = std::min(pixel_bytes, row_bytes);
  for (std::size_t i = 0; i < first; ++i) to[i] = static_cast<std::uint8_t>(row[i] - Filter::predict(0, above[i], 0));
  const std::uint8_t* __restrict const left = row - pixel_bytes;
  const std::uint8_t* __restrict const corner = above - pixel_bytes;
  for (std::size_t i = first; i < row_bytes; ++i)
    to[i] = static_cast<std::uint8_t>(row[i] - Filter::predict(left[i], above[i], corner[i]));
}

/// Of bytes taken as signed. A row of 65,536 pixels of 8 bytes, the longest, stays within 2^26.
std::uint32_t sum_of_magnitudes(const std::uint8_t* bytes, std::size_t count) {
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < count; ++i)
    sum += static_cast<std::uint32_t>(std::min<std::uint8_t>(bytes[i], static_cast<std::uint8_t>(-bytes[i])));
  return sum;
}

using Apply = void (*)(const std::uint8_t*, const std::uint8_t*, std::size_t, std::size_t, std::uint8_t*);
constexpr Apply filters[] = {apply<None>, apply<Sub>, apply<Up>, apply<Average>, apply<Paeth>};

} // namespace

RowFilter::RowFilter(std::size_t row_bytes, std::size_t pixel_bytes)
    : row_bytes_(row_bytes), pixel_bytes_(pixel_bytes), zeros_(row_bytes), candidate_(row_bytes) {}

void RowFilter::filter(const std::uint8_t* row, const std::uint8_t* above, std::uint8_t* to) {
  if (!above) above = zeros_.data();
  std::uint32_t smallest = std::numeric_limits<std::uint32_t>::max();
  for (std::size_t number = 0; number < std::size(filters) && smallest > 0; ++number) {
    filters[number](row, above, row_bytes_, pixel_bytes_, candidate_.data());
    const std::uint32_t sum = sum_of_magnitudes(candidate_.data(), row_bytes_);
    if (sum >= smallest) continue;
    smallest = sum;
    to[0] = static_cast<std::uint8_t>(number);
    std::memcpy(to + 1, candidate_.data(), row_bytes_);
  }
}

} // namespace refraster
