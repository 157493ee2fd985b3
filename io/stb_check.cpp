#include "io/image_formats.h"
#include "io/text.h"

#include <cstdlib>
#include <cstring>

// What stb_image 2.27 takes for granted of its input, checked before it is called.

namespace refraster {
namespace {

/// Deflate makes at most 1032 bytes of one, and the smallest pixel is one bit. The same bound holds for JPEG, which
/// codes a block of a component in two bits at least, or in one where it is progressive: 8 x 8 pixels, or 32 x 32 where
/// it is subsampled the most.
constexpr std::uint64_t packed_pixels_per_byte = 8 * 1032;
/// A pixel of one bit.
constexpr std::uint64_t bmp_pixels_per_byte = 8;
/// A run of 128 pixels of one byte takes two.
constexpr std::uint64_t tga_pixels_per_byte = 64;

[[noreturn]] void fail(const std::string& path, std::string place, std::string found, std::string expected) {
  throw InputError(InputFault{path, 0, 0, std::move(place), std::move(found), std::move(expected)});
}

std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, &bytes[at], sizeof value);
  return __builtin_bswap32(value);
}

template <class Value>
Value little_endian(std::string_view bytes, std::size_t at) {
  Value value = 0;
  std::memcpy(&value, &bytes[at], sizeof value);
  return value;
}

/// Chunks: length, type, data, checksum. Memory for the data of one is taken before it is read. A type that stb does
/// not know and must not skip, it puts into its message, which is the same memory for all threads. One that it does
/// know is Apple's, CgBI: blue before red, and colours multiplied by alpha, which it leaves so.
void check_png(const std::string& path, std::string_view bytes, const ImageRequest& request) {
  constexpr std::size_t signature = 8, around_data = 12;
  for (std::size_t at = signature; at < bytes.size();) {
    if (bytes.size() - at < around_data) throw truncated_image(path);
    const std::size_t length = big_endian(bytes, at);
    const std::string_view type = bytes.substr(at + 4, 4);
    if (length > bytes.size() - at - around_data) throw truncated_image(path);
    // stb calls a PNG that is too large an unknown image.
    if (type == "IHDR" && length == 13)
      check_image_size(path, big_endian(bytes, at + 8), big_endian(bytes, at + 12), bytes.size(),
                       packed_pixels_per_byte, request);
    if (type == "IEND") return;
    const bool may_be_skipped = (static_cast<unsigned char>(type[0]) & 0x20) != 0;
    if (!may_be_skipped && type != "IHDR" && type != "PLTE" && type != "IDAT")
      fail(path, "", "a chunk " + in_quotes(type), "IHDR, PLTE, IDAT, IEND, or one that may be skipped");
    at += around_data + length;
  }
  throw truncated_image(path);
}

struct BmpLayout {
  std::uint64_t start, row_bytes, width, height; // of the pixels; rows are padded to four bytes
  std::uint32_t header_bytes, bits, colours;
};

BmpLayout bmp_layout(const std::string& path, std::string_view bytes, const ImageRequest& request) {
  constexpr std::size_t file_header = 14, os2_header = 12, smallest = file_header + 40;
  if (bytes.size() < file_header + os2_header) throw truncated_image(path);
  BmpLayout bmp{};
  bmp.start = little_endian<std::uint32_t>(bytes, 10);
  bmp.header_bytes = little_endian<std::uint32_t>(bytes, file_header);
  const bool is_os2 = bmp.header_bytes == os2_header;
  if (!is_os2 && bytes.size() < smallest) throw truncated_image(path);
  if (is_os2) {
    bmp.width = little_endian<std::uint16_t>(bytes, 18);
    bmp.height = little_endian<std::uint16_t>(bytes, 20);
    bmp.bits = little_endian<std::uint16_t>(bytes, 24);
  } else {
    bmp.width = little_endian<std::uint32_t>(bytes, 18);
    bmp.height = static_cast<std::uint64_t>(std::abs(std::int64_t{little_endian<std::int32_t>(bytes, 22)}));
    bmp.bits = little_endian<std::uint16_t>(bytes, 28);
  }
  check_image_size(path, bmp.width, bmp.height, bytes.size(), bmp_pixels_per_byte, request);
  bmp.row_bytes = (bmp.width * bmp.bits + 31) / 32 * 4;
  if (bmp.bits >= 16) return bmp;
  if (is_os2) fail(path, "", "a BMP of OS/2 with a palette", "one of Windows, or without a palette");
  const std::uint64_t palette = file_header + std::uint64_t{bmp.header_bytes};
  if (bmp.start < palette + 4 || bmp.start > palette + 4 * 256)
    fail(path, "", "pixels that start at byte " + std::to_string(bmp.start),
         "byte " + std::to_string(palette + 4) + " to " + std::to_string(palette + 4 * 256) + ", behind the palette");
  bmp.colours = static_cast<std::uint32_t>((bmp.start - palette) / 4);
  return bmp;
}

void check_bmp(const std::string& path, std::string_view bytes, const ImageRequest& request) {
  const BmpLayout bmp = bmp_layout(path, bytes, request);
  // The last row may lack its padding.
  const std::uint64_t last_row = (bmp.width * bmp.bits + 7) / 8;
  if (bytes.size() < bmp.start + bmp.row_bytes * (bmp.height - 1) + last_row) throw truncated_image(path);
  const bool is_known = bmp.bits == 1 || bmp.bits == 4 || bmp.bits == 8; // stb refuses others
  if (!is_known || bmp.colours >= 1u << bmp.bits) return;
  for (std::uint64_t y = 0; y < bmp.height; ++y)
    for (std::uint64_t x = 0; x < bmp.width; ++x) {
      const std::uint64_t bit = x * bmp.bits;
      const auto byte = static_cast<std::uint8_t>(bytes[bmp.start + y * bmp.row_bytes + bit / 8]);
      const std::uint32_t colour = byte >> (8 - bmp.bits - bit % 8) & ((1u << bmp.bits) - 1);
      if (colour >= bmp.colours)
        fail(path, "pixel " + std::to_string(x) + " of stored row " + std::to_string(y),
             "colour " + std::to_string(colour), "0 to " + std::to_string(bmp.colours - 1));
    }
}

} // namespace

std::uint64_t check_before_stb(const std::string& path, std::string_view bytes, const ImageRequest& request) {
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) {
    check_png(path, bytes, request);
    return packed_pixels_per_byte;
  }
  if (bytes.starts_with("\xff\xd8")) return packed_pixels_per_byte;
  if (bytes.starts_with("BM")) {
    check_bmp(path, bytes, request);
    return bmp_pixels_per_byte;
  }
  return tga_pixels_per_byte;
}

} // namespace refraster
