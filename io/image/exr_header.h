#pragma once
// The header of an OpenEXR file.

#include "io/image/image_reading.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace refraster {

/// What of it decides where and how the pixels lie.
struct ExrHeader {
  std::uint64_t width = 0, height = 0;
  std::int32_t min_y = 0; // of the first row
  std::uint8_t compression = 0;
  std::uint64_t tile_width = 0, tile_height = 0; // 0: rows, not tiles
  std::uint64_t bytes_a_pixel = 0;               // of all channels
  std::size_t end = 0;                           // byte behind the header

  /// Rows that are packed together, where there are no tiles.
  std::uint64_t rows_together() const;
};

/// Throws InputError for what OpenEXR must not see: images that are deep, of several parts, or of a size that the file
/// cannot hold, channels that are not of the image's size, rows or tiles packed together that are much larger than the
/// image.
ExrHeader read_exr_header(const std::string& path, std::string_view bytes, const ImageRequest& request);

/// What OpenEXR must not see: see read_exr_header; and a file that lacks rows or tiles, or in which one of them does
/// not fill its place: OpenEXR 3.1 takes the rest of it from memory. Throws InputError.
void check_before_exr(const std::string& path, std::string_view bytes, const ImageRequest& request);

} // namespace refraster
