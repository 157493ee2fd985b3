#include "tests/unit/verify/unpacked.h"

#include <doctest/doctest.h>

#include <zlib.h>

#include <cstdlib>

namespace refraster::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// RFC 4648, 4, letter by letter.
Bytes bytes_of_base64(std::string_view text) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  REQUIRE(text.size() % 4 == 0);
  Bytes bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    const std::size_t digit = letters.find(c);
    REQUIRE(digit != std::string_view::npos);
    bits = (bits << 6) | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<std::uint8_t>(bits >> count));
  }
  return bytes;
}

Bytes inflated(std::string_view text, std::size_t size) {
  const Bytes packed = bytes_of_base64(text);
  Bytes bytes(size);
  uLongf found = static_cast<uLongf>(size);
  REQUIRE(uncompress(bytes.data(), &found, packed.data(), static_cast<uLong>(packed.size())) == Z_OK);
  REQUIRE(found == size);
  return bytes;
}

} // namespace

Bytes unpacked_rows(std::string_view text, int width, int height, int channels) {
  const auto step = static_cast<std::size_t>(channels), row = step * static_cast<std::size_t>(width);
  const auto rows = static_cast<std::size_t>(height);
  const Bytes raw = inflated(text, rows * (row + 1));
  Bytes out(rows * row);
  const auto at = [&](std::size_t y, std::ptrdiff_t i) { // of row y - 1 and column i, 0 outside
    return y == 0 || i < 0 ? 0 : static_cast<int>(out[(y - 1) * row + static_cast<std::size_t>(i)]);
  };
  for (std::size_t y = 0; y < rows; ++y) {
    const int filter = raw[y * (row + 1)];
    for (std::size_t i = 0; i < row; ++i) {
      const auto before = static_cast<std::ptrdiff_t>(i) - static_cast<std::ptrdiff_t>(step);
      const int a = at(y + 1, before), b = at(y, static_cast<std::ptrdiff_t>(i)), c = at(y, before);
      int foreseen = 0;
      if (filter == 1) foreseen = a;
      else if (filter == 2) foreseen = b;
      else if (filter == 3) foreseen = (a + b) / 2;
      else if (filter == 4) {
        const int pa = std::abs(b - c), pb = std::abs(a - c), pc = std::abs(a + b - 2 * c);
        foreseen = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
      } else REQUIRE(filter == 0);
      out[y * row + i] = static_cast<std::uint8_t>(raw[y * (row + 1) + 1 + i] + foreseen);
    }
  }
  return out;
}

std::vector<std::uint32_t> numbers_of(const Bytes& bytes) {
  const std::size_t count = bytes.size() / 4;
  std::vector<std::uint32_t> numbers(count);
  for (std::size_t i = 0; i < bytes.size(); ++i) numbers[i % count] = (numbers[i % count] << 8) | bytes[i];
  return numbers;
}

std::string unpacked_text(std::string_view text, std::size_t size) {
  const Bytes bytes = inflated(text, size);
  return {bytes.begin(), bytes.end()};
}

std::string plane_of(const std::string& page, const std::string& id) {
  const std::size_t start = page.find("id=\"plane-" + id + "\"");
  REQUIRE(start != std::string::npos);
  const std::size_t from = page.find('>', start) + 1;
  return page.substr(from, page.find('<', from) - from);
}

} // namespace refraster::test
