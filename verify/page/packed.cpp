#include "verify/page/packed.h"

#include "io/html/base64.h"
#include "io/image/png/png_filter.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <new>
#include <stdexcept>

namespace refraster {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes filtered(const Bytes& bytes, std::size_t row_bytes, std::size_t step) {
  const std::size_t rows = row_bytes == 0 ? 0 : bytes.size() / row_bytes;
  Bytes result(rows * (row_bytes + 1));
  RowFilter filter(row_bytes, step);
  for (std::size_t y = 0; y < rows; ++y) {
    const std::uint8_t* const row = &bytes[y * row_bytes];
    filter.filter(row, y == 0 ? nullptr : row - row_bytes, &result[y * (row_bytes + 1)]);
  }
  return result;
}

Bytes deflated(const Bytes& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  Bytes result(size);
  // 9 takes up to three times as long as zlib's default, for a hundredth of the size.
  if (compress2(result.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()), Z_DEFAULT_COMPRESSION) != Z_OK)
    throw std::bad_alloc();
  result.resize(size);
  return result;
}

std::string packed_rows(const Bytes& bytes, int width, int channels) {
  const auto step = static_cast<std::size_t>(channels);
  return base64(deflated(filtered(bytes, step * static_cast<std::size_t>(width), step)));
}

/// The highest bytes of all numbers, then the next ones.
Bytes byte_planes(const std::vector<std::uint32_t>& numbers) {
  Bytes bytes;
  bytes.reserve(4 * numbers.size());
  for (const int shift : {24, 16, 8, 0})
    for (const std::uint32_t number : numbers) bytes.push_back(static_cast<std::uint8_t>(number >> shift));
  return bytes;
}

std::vector<std::uint32_t> bits_of(const std::vector<float>& values) {
  std::vector<std::uint32_t> bits;
  bits.reserve(values.size());
  for (const float value : values) bits.push_back(std::bit_cast<std::uint32_t>(value));
  return bits;
}

template <class Value>
void need_same_size(const Image<Value>& a, const Image<Value>& b) {
  if (a.width != b.width || a.height != b.height || a.channels != b.channels)
    throw std::invalid_argument("packed_difference: found images of different sizes, expected the same size");
}

} // namespace

std::string packed(const Image<std::uint8_t>& image) {
  return packed_rows(image.values, image.width, image.channels);
}
std::string packed(const Image<std::uint32_t>& image) {
  return packed_rows(byte_planes(image.values), image.width, image.channels);
}
std::string packed(const Image<float>& image) {
  return packed_rows(byte_planes(bits_of(image.values)), image.width, image.channels);
}

std::string packed(std::string_view text) {
  return base64(deflated(Bytes(text.begin(), text.end())));
}

std::string packed_difference(const Image<std::uint8_t>& image, const Image<std::uint8_t>& base) {
  need_same_size(image, base);
  Bytes left(image.values.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = static_cast<std::uint8_t>(image.values[i] - base.values[i]);
  return packed_rows(left, image.width, image.channels);
}
std::string packed_difference(const Image<float>& image, const Image<float>& base) {
  need_same_size(image, base);
  std::vector<std::uint32_t> left = bits_of(image.values);
  const std::vector<std::uint32_t> base_bits = bits_of(base.values);
  for (std::size_t i = 0; i < left.size(); ++i) {
    const std::uint32_t d = left[i] - base_bits[i];
    left[i] = (d << 1) ^ (0 - (d >> 31)); // small of either sign, small bits
  }
  return packed_rows(byte_planes(left), image.width, image.channels);
}

} // namespace refraster
