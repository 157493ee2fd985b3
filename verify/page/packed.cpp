#include "verify/page/packed.h"

#include <openssl/evp.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <limits>
#include <new>
#include <stdexcept>

namespace refraster {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// PNG's predictor of one byte from its neighbours: left, above, and left of that above.
int paeth(int left, int above, int corner) {
  const int p = left + above - corner;
  const int to_left = std::abs(p - left), to_above = std::abs(p - above), to_corner = std::abs(p - corner);
  if (to_left <= to_above && to_left <= to_corner) return left;
  return to_above <= to_corner ? above : corner;
}

enum Filter : std::uint8_t { none = 0, sub = 1, up = 2, paeth_filter = 4 };
constexpr std::array<Filter, 4> filters = {none, sub, up, paeth_filter};

/// A row less what a filter foresees of it; step: bytes to the neighbour on the left.
void filter_row(Filter filter, const std::uint8_t* row, const std::uint8_t* above, std::size_t size, std::size_t step,
                std::uint8_t* out) {
  for (std::size_t i = 0; i < size; ++i) {
    const int left = i < step ? 0 : row[i - step], corner = i < step ? 0 : above[i - step];
    int foreseen = 0;
    if (filter == sub) foreseen = left;
    else if (filter == up) foreseen = above[i];
    else if (filter == paeth_filter) foreseen = paeth(left, above[i], corner);
    out[i] = static_cast<std::uint8_t>(row[i] - foreseen);
  }
}

/// How much is left, each byte taken as a small number of either sign.
std::uint64_t rest(const Bytes& row) {
  std::uint64_t sum = 0;
  for (const std::uint8_t byte : row) sum += static_cast<std::uint64_t>(std::min<int>(byte, 256 - byte));
  return sum;
}

Bytes filtered(const Bytes& bytes, std::size_t row_bytes, std::size_t step) {
  Bytes result, candidate(row_bytes), best;
  const Bytes zeros(row_bytes);
  const std::size_t rows = row_bytes == 0 ? 0 : bytes.size() / row_bytes;
  result.reserve(rows * (row_bytes + 1));
  for (std::size_t y = 0; y < rows; ++y) {
    const std::uint8_t *row = &bytes[y * row_bytes], *above = y == 0 ? zeros.data() : row - row_bytes;
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
    Filter chosen = none;
    for (const Filter filter : filters) {
      filter_row(filter, row, above, row_bytes, step, candidate.data());
      const std::uint64_t left = rest(candidate);
      if (left >= least) continue;
      least = left, chosen = filter;
      best = candidate;
    }
    result.push_back(chosen);
    result.insert(result.end(), best.begin(), best.end());
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

std::string base64(const Bytes& bytes) {
  constexpr std::size_t part = 3 << 20; // OpenSSL counts in int; of 3 bytes, so that no padding stands within
  std::string text;
  text.reserve(4 * ((bytes.size() + 2) / 3));
  std::string letters(4 * (part / 3) + 1, '\0'); // and a 0, which it writes behind them
  for (std::size_t at = 0; at < bytes.size(); at += part) {
    const auto size = static_cast<int>(std::min(part, bytes.size() - at));
    const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(letters.data()), &bytes[at], size);
    text.append(letters, 0, static_cast<std::size_t>(length));
  }
  return text;
}

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
