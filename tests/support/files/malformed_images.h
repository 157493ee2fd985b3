#pragma once
// Images with a fault that stb_image or OpenEXR would not notice, or not survive. Part of malformed_inputs().

#include "tests/support/files/malformed_inputs.h"

namespace refraster::test {

std::vector<MalformedInput> malformed_images();

/// A BMP with a palette and rows as they are stored; a negative height: the top row first.
std::string bmp_bytes(std::int32_t width, std::int32_t height, int bits, const std::string& palette,
                      const std::string& rows);

/// An OpenEXR file of one channel Y of 32-bit floats, rows not packed together. `compression` by its number; `chunks`:
/// what each row holds, packed.
std::string exr_bytes(std::int32_t width, char compression, const std::vector<std::string>& chunks,
                      std::uint32_t flags = 0, const std::string& more_attributes = "");

} // namespace refraster::test
