#pragma once
// PNG files of any number of channels and depth, written here, so that reading is not tested against our own writer.

#include <cstdint>
#include <string>
#include <vector>

namespace refraster::test {

/// A chunk with its length and CRC.
std::string png_chunk(const std::string& type, const std::string& data);

/// IHDR; `colour_type` as the specification numbers them.
std::string png_header(std::uint32_t width, std::uint32_t height, int bits, int colour_type, int interlace = 0);

/// A zlib stream that holds less than 64 KiB as they are.
std::string zlib_stored(const std::string& data);

inline const std::string png_signature = "\x89PNG\r\n\x1a\n";

/// Big-endian, as PNG has numbers.
std::string big_endian(std::uint32_t value);

/// A PNG of 1 to 4 channels with 8 or 16 bits; samples interleaved, row 0 at the top. Not compressed.
std::string png_bytes(std::uint32_t width, std::uint32_t height, int channels, int bits,
                      const std::vector<std::uint16_t>& samples);

} // namespace refraster::test
