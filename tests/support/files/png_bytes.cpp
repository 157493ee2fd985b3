#include "tests/support/files/png_bytes.h"

namespace refraster::test {
namespace {

/// PNG specification, annex D.
std::uint32_t crc32(const std::string& bytes) {
  std::uint32_t crc = 0xffffffffu;
  for (const char c : bytes) {
    crc ^= static_cast<std::uint8_t>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1u ? 0xedb88320u : 0u);
  }
  return ~crc;
}

} // namespace

std::string big_endian(std::uint32_t value) {
  return {static_cast<char>(value >> 24), static_cast<char>(value >> 16), static_cast<char>(value >> 8),
          static_cast<char>(value)};
}

std::string png_chunk(const std::string& type, const std::string& data) {
  return big_endian(static_cast<std::uint32_t>(data.size())) + type + data + big_endian(crc32(type + data));
}

std::string png_header(std::uint32_t width, std::uint32_t height, int bits, int colour_type, int interlace) {
  std::string header = big_endian(width) + big_endian(height);
  header += {static_cast<char>(bits), static_cast<char>(colour_type), 0, 0, static_cast<char>(interlace)};
  return png_chunk("IHDR", header);
}

// RFC 1950 and 1951: one stored block.
std::string zlib_stored(const std::string& data) {
  const auto size = static_cast<std::uint16_t>(data.size()), complement = static_cast<std::uint16_t>(~size);
  std::uint32_t a = 1, b = 0;
  for (const char c : data) {
    a = (a + static_cast<std::uint8_t>(c)) % 65521;
    b = (b + a) % 65521;
  }
  std::string block = "\x78\x01\x01";
  for (const std::uint16_t field : {size, complement})
    block += {static_cast<char>(field & 255), static_cast<char>(field >> 8)};
  return block + data + big_endian(b << 16 | a);
}

std::string png_bytes(std::uint32_t width, std::uint32_t height, int channels, int bits,
                      const std::vector<std::uint16_t>& samples) {
  constexpr int colour_types[] = {0, 0, 4, 2, 6};
  std::string rows;
  std::size_t next = 0;
  for (std::uint32_t y = 0; y < height; ++y) {
    rows += '\0'; // no filter
    for (std::uint32_t i = 0; i < width * static_cast<std::uint32_t>(channels); ++i, ++next) {
      if (bits == 16) rows += static_cast<char>(samples[next] >> 8);
      rows += static_cast<char>(samples[next] & 255);
    }
  }
  return png_signature + png_header(width, height, bits, colour_types[channels]) +
         png_chunk("IDAT", zlib_stored(rows)) + png_chunk("IEND", "");
}

} // namespace refraster::test
