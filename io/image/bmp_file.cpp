#include "io/image/image_formats.h"
#include "io/image/little_endian.h"
#include "io/image/packed_colour.h"

#include <array>
#include <cstdlib>

// BMP by stb_image, behind a header of the plainest kind that is made here: stb_image 2.27 refuses half of the headers,
// gaps, and palettes that it does not need; forgets colours of OS/2 palettes; takes an index beyond the palette for
// whatever was in memory; and widens channels of 5 and 6 bits to a neighbour of the nearest level.
// Microsoft: Bitmap Storage; OS/2: the Presentation Manager's BITMAPFILEHEADER and BITMAPINFOHEADER2.

namespace refraster {
namespace {

/// A pixel of one bit.
constexpr std::uint64_t pixels_per_byte = 8;

constexpr std::size_t file_header = 14, core_header = 12, info_header = 40;
constexpr std::uint32_t header_sizes[] = {12, 16, 40, 52, 56, 64, 108, 124};
enum Compression : std::uint32_t { none = 0, bit_fields = 3, alpha_bit_fields = 6 };

struct Bmp {
  std::uint64_t width, height; // in pixels
  bool top_row_first;
  std::uint32_t header_bytes, bits, compression;
  std::uint64_t start, row_bytes;     // of the pixels; rows are padded to four bytes
  std::uint64_t palette;              // where it begins: behind the headers
  std::uint32_t declared_colours;     // 0: not said
  std::array<std::uint32_t, 4> masks; // R G B A, of 16 and 32 bits
};

const char* compression_name(const Bmp& bmp) {
  const bool is_os2 = bmp.header_bytes == 64;
  switch (bmp.compression) {
  case 1:
    return "RLE8 compression";
  case 2:
    return "RLE4 compression";
  case 3:
    return is_os2 ? "Huffman compression" : "masks";
  case 4:
    return is_os2 ? "RLE24 compression" : "a JPEG inside";
  case 5:
    return "a PNG inside";
  case 6:
    return "masks";
  default:
    return "an unknown compression";
  }
}

void check_compression(const std::string& path, const Bmp& bmp) {
  if (bmp.bits != 1 && bmp.bits != 4 && bmp.bits != 8 && bmp.bits != 16 && bmp.bits != 24 && bmp.bits != 32)
    refuse_image(path, "", std::to_string(bmp.bits) + " bits a pixel", "1, 4, 8, 16, 24 or 32");
  if (bmp.compression == none) return;
  const bool has_masks =
      (bmp.compression == bit_fields && bmp.header_bytes != 64) || bmp.compression == alpha_bit_fields;
  if (!has_masks) refuse_image(path, "", compression_name(bmp), "pixels that are not compressed");
  if (bmp.bits != 16 && bmp.bits != 32)
    refuse_image(path, "", "masks for " + std::to_string(bmp.bits) + " bits a pixel", "masks for 16 or 32");
}

/// The masks stand at the same place whether they belong to the header or follow it.
void read_masks(const std::string& path, std::string_view bytes, Bmp& bmp) {
  if (bmp.compression == none) {
    bmp.masks = {0x7c00, 0x03e0, 0x001f, 0};
    if (bmp.bits == 32) bmp.masks = {0xff0000, 0xff00, 0xff, 0};
    return;
  }
  const bool has_alpha = bmp.header_bytes >= 56 || bmp.compression == alpha_bit_fields;
  const std::size_t at = file_header + info_header, count = has_alpha ? 4 : 3;
  if (bmp.header_bytes == info_header) bmp.palette += 4 * count;
  if (bytes.size() < at + 4 * count) throw truncated_image(path);
  constexpr const char* names[] = {"red mask", "green mask", "blue mask", "alpha mask"};
  for (std::size_t c = 0; c < count; ++c) {
    const std::uint32_t mask = little_endian<std::uint32_t>(bytes, at + 4 * c);
    const bool has_bits = mask != 0 || c == 3, fits = bmp.bits == 32 || mask <= 0xffff;
    if (!has_bits || !fits || !is_contiguous(mask) || std::popcount(mask) > 16)
      refuse_image(path, names[c], std::to_string(mask), "1 to 16 bits of a pixel, side by side");
    bmp.masks[c] = mask;
  }
}

Bmp read_header(const std::string& path, std::string_view bytes, const ImageRequest& request) {
  if (bytes.size() < file_header + core_header) throw truncated_image(path);
  Bmp bmp{};
  bmp.start = little_endian<std::uint32_t>(bytes, 10);
  bmp.header_bytes = little_endian<std::uint32_t>(bytes, file_header);
  if (std::find(std::begin(header_sizes), std::end(header_sizes), bmp.header_bytes) == std::end(header_sizes))
    refuse_image(path, "", "a header of " + std::to_string(bmp.header_bytes) + " bytes",
                 "12, 16, 40, 52, 56, 64, 108 or 124");
  bmp.palette = file_header + bmp.header_bytes;
  if (bytes.size() < bmp.palette) throw truncated_image(path);
  std::uint32_t planes = 0;
  if (bmp.header_bytes == core_header) {
    bmp.width = little_endian<std::uint16_t>(bytes, 18);
    bmp.height = little_endian<std::uint16_t>(bytes, 20);
    planes = little_endian<std::uint16_t>(bytes, 22);
    bmp.bits = little_endian<std::uint16_t>(bytes, 24);
  } else {
    const std::int64_t height = little_endian<std::int32_t>(bytes, 22);
    bmp.width = little_endian<std::uint32_t>(bytes, 18);
    bmp.height = static_cast<std::uint64_t>(std::abs(height));
    bmp.top_row_first = height < 0;
    planes = little_endian<std::uint16_t>(bytes, 26);
    bmp.bits = little_endian<std::uint16_t>(bytes, 28);
  }
  if (bmp.header_bytes >= info_header) {
    bmp.compression = little_endian<std::uint32_t>(bytes, 30);
    bmp.declared_colours = little_endian<std::uint32_t>(bytes, 46);
  }
  if (planes != 1) refuse_image(path, "", std::to_string(planes) + " planes", "1");
  check_compression(path, bmp);
  check_image_size(path, bmp.width, bmp.height, bytes.size(), pixels_per_byte, request);
  bmp.row_bytes = (bmp.width * bmp.bits + 31) / 32 * 4;
  if (bmp.bits == 16 || bmp.bits == 32) read_masks(path, bytes, bmp);
  if (bmp.start < bmp.palette)
    refuse_image(path, "", "pixels that start at byte " + std::to_string(bmp.start),
                 "byte " + std::to_string(bmp.palette) + " or later, behind the header");
  // The last row may lack its padding.
  const std::uint64_t last_row = (bmp.width * bmp.bits + 7) / 8;
  if (bytes.size() < bmp.start + bmp.row_bytes * (bmp.height - 1) + last_row) throw truncated_image(path);
  return bmp;
}

/// As many colours as are said and are there, as blue, green, red and 0.
std::string read_palette(const std::string& path, std::string_view bytes, const Bmp& bmp) {
  const std::uint64_t most = std::uint64_t{1} << bmp.bits, entry = bmp.header_bytes == core_header ? 3 : 4;
  const std::uint64_t declared = bmp.declared_colours == 0 ? most : std::min<std::uint64_t>(bmp.declared_colours, most);
  const std::uint64_t count = std::min(declared, (bmp.start - bmp.palette) / entry);
  if (count == 0)
    refuse_image(path, "", "pixels that start at byte " + std::to_string(bmp.start),
                 "byte " + std::to_string(bmp.palette + entry) + " or later, behind the palette");
  std::string palette;
  for (std::uint64_t i = 0; i < count; ++i) palette.append(bytes.substr(bmp.palette + entry * i, 3)).push_back('\0');
  return palette;
}

void check_indices(const std::string& path, const Bmp& bmp, std::string_view pixels, std::uint64_t colours) {
  if (colours >= 1u << bmp.bits) return;
  for (std::uint64_t y = 0; y < bmp.height; ++y)
    for (std::uint64_t x = 0; x < bmp.width; ++x) {
      const std::uint64_t bit = x * bmp.bits;
      const auto byte = static_cast<std::uint8_t>(pixels[y * bmp.row_bytes + bit / 8]);
      const std::uint32_t colour = byte >> (8 - bmp.bits - bit % 8) & ((1u << bmp.bits) - 1);
      if (colour >= colours)
        refuse_image(path, "pixel " + std::to_string(x) + " of stored row " + std::to_string(y),
                     "colour " + std::to_string(colour), "0 to " + std::to_string(colours - 1));
    }
}

/// What stb_image is given for a header: 40 bytes; or, for pixels with masks, 108, and masks that give it their bytes.
std::string plain_header(const Bmp& bmp, const std::string& palette) {
  const bool has_masks = bmp.bits == 16 || bmp.bits == 32;
  const std::uint32_t size = has_masks ? 108 : info_header;
  const std::int32_t height = static_cast<std::int32_t>(bmp.height);
  std::string header = "BM";
  const auto add = [&header](auto value) { append_little_endian(header, value); };
  add(std::uint32_t{0}), add(std::uint32_t{0}); // size of the file, reserved
  add(static_cast<std::uint32_t>(file_header + size + palette.size()));
  add(size), add(static_cast<std::uint32_t>(bmp.width)), add(bmp.top_row_first ? -height : height);
  add(std::uint16_t{1}), add(static_cast<std::uint16_t>(bmp.bits));
  add(std::uint32_t{has_masks ? bit_fields : none});
  header.resize(file_header + info_header);
  if (has_masks) {
    add(std::uint32_t{0xff}), add(std::uint32_t{0xff00});
    add(std::uint32_t{bmp.bits == 32 ? 0xff0000u : 0xffu}), add(std::uint32_t{bmp.bits == 32 ? 0xff000000u : 0u});
    header.resize(file_header + size);
  }
  return header + palette;
}

/// Where a header has no place for alpha, the fourth byte means nothing; but some programs write alpha there.
bool has_meaningless_bytes(const Bmp& bmp, const StbPixels& raw) {
  if (bmp.bits != 32 || bmp.compression != none) return false;
  const std::uint8_t* const fourth = raw.values.get() + 3;
  for (std::size_t i = 0; i < bmp.width * bmp.height; ++i)
    if (fourth[4 * i] != fourth[0]) return true;
  return false;
}

/// Channels under masks: 8 bits, or 16 where one of them has more.
void read_masked(const Bmp& bmp, const StbPixels& raw, ImageFile& image) {
  const int channels = bmp.masks[3] == 0 ? 3 : 4;
  image.values = Image<float>(raw.width, raw.height, channels);
  int widest = 0;
  for (const std::uint32_t mask : bmp.masks) widest = std::max(widest, std::popcount(mask));
  image.bits = widest > 8 ? 16 : 8;
  const std::uint32_t full_scale = widest > 8 ? 65535 : 255;
  image.full_scale = full_scale;
  const std::uint8_t* from = raw.values.get();
  float* to = image.values.values.data();
  for (std::uint64_t i = 0; i < bmp.width * bmp.height; ++i, from += raw.channels) {
    std::uint32_t packed = from[0] | std::uint32_t{from[1]} << 8;
    if (bmp.bits == 32) packed |= std::uint32_t{from[2]} << 16 | std::uint32_t{from[3]} << 24;
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c)
      *to++ = channel_of(packed, bmp.masks[c], full_scale);
  }
}

} // namespace

ImageFile read_bmp(const std::string& path, std::string_view bytes, const ImageRequest& request) {
  const Bmp bmp = read_header(path, bytes, request);
  const bool has_palette = bmp.bits <= 8, has_masks = bmp.bits == 16 || bmp.bits == 32;
  const std::string_view pixels = bytes.substr(bmp.start);
  std::string palette;
  if (has_palette) {
    palette = read_palette(path, bytes, bmp);
    check_indices(path, bmp, pixels, palette.size() / 4);
  }
  need_image(request, path, bmp.width * bmp.height, has_masks ? 4 : 3, 1);
  const StbPixels raw = decode_stb(path, plain_header(bmp, palette), pixels);
  ImageFile image;
  if (has_masks) {
    read_masked(bmp, raw, image);
    if (has_meaningless_bytes(bmp, raw))
      image.notes.add({path, 0, "a fourth byte that differs from pixel to pixel, and no alpha mask",
                       "read as red, green and blue, without alpha", 1});
  } else {
    image.values = Image<float>(raw.width, raw.height, raw.channels);
    std::copy_n(raw.values.get(), image.values.values.size(), image.values.values.begin());
  }
  image.channels = default_channels(image.values.channels);
  return image;
}

} // namespace refraster
