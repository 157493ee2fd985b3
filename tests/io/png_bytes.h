#pragma once
// PNG files of any number of channels and depth, written here, so that reading is not tested against our own writer.

#include <cstdint>
#include <string>
#include <vector>

namespace refraster::test {

/// A PNG of 1 to 4 channels with 8 or 16 bits; samples interleaved, row 0 at the top. Not compressed.
std::string png_bytes(std::uint32_t width, std::uint32_t height, int channels, int bits,
                      const std::vector<std::uint16_t>& samples);

} // namespace refraster::test
