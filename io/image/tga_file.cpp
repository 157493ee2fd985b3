#include "io/image/image_formats.h"
#include "io/image/little_endian.h"
#include "io/image/packed_colour.h"

#include <array>

// TGA by stb_image, which unpacks the run lengths behind a header that is made here. What pixels mean is decided here:
// stb_image 2.27 leaves the right-to-left origin out, skips as many bytes as the number of the colour map's first
// entry, takes an index beyond the map for its first colour, refuses a map that pixels do not use, and rounds 5 bits
// down. Truevision TGA File Format Specification, version 2.0.

namespace refraster {
namespace {

/// A run of 128 pixels of one byte takes two.
constexpr std::uint64_t pixels_per_byte = 64;

constexpr std::size_t header_bytes = 18;
enum class Kind { map = 1, true_colour = 2, grey = 3 };

struct Tga {
  std::size_t id_bytes;
  int map_type, type;
  std::uint32_t map_first, map_length, map_bits;
  std::uint32_t width, height, bits;
  std::uint8_t descriptor;

  Kind kind() const { return static_cast<Kind>(type & 3); }
  bool right_to_left() const { return descriptor & 0x10; }
  bool top_row_first() const { return descriptor & 0x20; }
  std::size_t map_entry_bytes() const { return (map_bits + 7) / 8; }
  std::size_t map_begin() const { return header_bytes + id_bytes; }
  std::size_t pixels_begin() const { return map_begin() + (map_type == 1 ? map_length * map_entry_bytes() : 0); }
};

constexpr bool is_type(int type) {
  return (type >= 1 && type <= 3) || (type >= 9 && type <= 11);
}

Tga header_of(std::string_view bytes) {
  const auto byte = [&](std::size_t at) { return little_endian<std::uint8_t>(bytes, at); };
  const auto word = [&](std::size_t at) { return std::uint32_t{little_endian<std::uint16_t>(bytes, at)}; };
  return {byte(0), byte(1), byte(2), word(3), word(5), byte(7), word(12), word(14), byte(16), byte(17)};
}

bool is_colour(std::uint32_t bits) {
  return bits == 15 || bits == 16 || bits == 24 || bits == 32;
}

void check_header(const std::string& path, const Tga& tga) {
  const bool has_map = tga.map_type == 1;
  const auto bits = [&](bool known, const char* what, std::uint32_t found, const char* expected) {
    if (!known) refuse_image(path, "", std::to_string(found) + " bits a " + what, expected);
  };
  switch (tga.kind()) {
  case Kind::map:
    if (!has_map || tga.map_length == 0)
      refuse_image(path, "", "pixels that are numbers of colours, and no colour map", "a colour map");
    bits(is_colour(tga.map_bits), "colour of the map", tga.map_bits, "15, 16, 24 or 32");
    bits(tga.bits == 8 || tga.bits == 16, "number of a colour", tga.bits, "8 or 16");
    break;
  case Kind::true_colour:
    bits(is_colour(tga.bits), "pixel", tga.bits, "15, 16, 24 or 32");
    break;
  case Kind::grey:
    bits(tga.bits == 8 || tga.bits == 16, "grey pixel", tga.bits, "8, or 16 with alpha");
    break;
  }
  if (tga.descriptor & 0xc0) refuse_image(path, "", "interleaved rows", "rows one after the other");
}

/// A header for stb_image: no map, no id, the first row at the top; pixels of one or two bytes as grey, of three or
/// four as colour.
std::string plain_header(const Tga& tga) {
  const std::size_t pixel_bytes = (tga.bits + 7) / 8;
  std::string header(2, '\0');
  append_little_endian(header, static_cast<std::uint8_t>((pixel_bytes < 3 ? 3 : 2) | (tga.type & 8)));
  header.append(9, '\0');
  append_little_endian(header, static_cast<std::uint16_t>(tga.width));
  append_little_endian(header, static_cast<std::uint16_t>(tga.height));
  append_little_endian(header, static_cast<std::uint8_t>(8 * pixel_bytes));
  append_little_endian(header, std::uint8_t{0x20});
  return header;
}

using Colour = std::array<float, 4>;

/// Five bits a channel; the attribute bit of 16 is not read, as nobody agrees on what it means.
Colour colour_of_word(std::uint32_t word) {
  return {channel_of(word, 0x7c00, 255), channel_of(word, 0x03e0, 255), channel_of(word, 0x001f, 255), 255};
}

/// The colours of the map, whose first has the number map_first.
std::vector<Colour> colour_map(const Tga& tga, std::string_view bytes) {
  std::vector<Colour> colours;
  for (std::uint32_t i = 0; i < tga.map_length; ++i) {
    const std::size_t at = tga.map_begin() + i * tga.map_entry_bytes();
    const auto byte = [&](std::size_t c) { return static_cast<float>(little_endian<std::uint8_t>(bytes, at + c)); };
    if (tga.map_bits <= 16) colours.push_back(colour_of_word(little_endian<std::uint16_t>(bytes, at)));
    else colours.push_back({byte(2), byte(1), byte(0), tga.map_bits == 32 ? byte(3) : 255});
  }
  return colours;
}

int channels_of(const Tga& tga) {
  if (tga.kind() == Kind::grey) return tga.bits == 8 ? 1 : 2;
  return (tga.kind() == Kind::map ? tga.map_bits : tga.bits) == 32 ? 4 : 3;
}

/// Pixels as they are stored, into rows from the top and from the left.
Image<float> oriented(const std::string& path, const Tga& tga, const StbPixels& raw,
                      const std::vector<Colour>& colours) {
  const int channels = channels_of(tga);
  Image<float> image(raw.width, raw.height, channels);
  const std::uint8_t* from = raw.values.get();
  for (int y = 0; y < raw.height; ++y)
    for (int x = 0; x < raw.width; ++x, from += raw.channels) {
      float* const to =
          image.at(tga.right_to_left() ? raw.width - 1 - x : x, tga.top_row_first() ? y : raw.height - 1 - y);
      const std::uint32_t word = from[0] | (raw.channels == 2 ? std::uint32_t{from[1]} << 8 : 0u);
      if (tga.kind() == Kind::map) {
        // Below the first wraps to a large number.
        if (const std::uint32_t number = word - tga.map_first; number < colours.size())
          std::copy_n(colours[number].begin(), channels, to);
        else
          refuse_image(path, "pixel " + std::to_string(x) + " of stored row " + std::to_string(y),
                       "colour " + std::to_string(word),
                       std::to_string(tga.map_first) + " to " + std::to_string(tga.map_first + tga.map_length - 1));
      } else if (tga.kind() == Kind::true_colour && raw.channels == 2) {
        std::copy_n(colour_of_word(word).begin(), channels, to);
      } else {
        std::copy_n(from, channels, to);
      }
    }
  return image;
}

} // namespace

bool may_be_tga(std::string_view prefix) {
  if (prefix.size() < header_bytes) return false;
  const Tga tga = header_of(prefix);
  const bool has_known_bits = tga.bits == 8 || is_colour(tga.bits);
  return (tga.map_type == 0 || tga.map_type == 1) && is_type(tga.type) && has_known_bits;
}

ImageFile read_tga(const std::string& path, std::string_view bytes, const ImageRequest& request) {
  const Tga tga = header_of(bytes);
  check_header(path, tga);
  check_image_size(path, tga.width, tga.height, bytes.size(), pixels_per_byte, request);
  if (bytes.size() < tga.pixels_begin()) throw truncated_image(path);
  need_image(request, path, std::uint64_t{tga.width} * tga.height, channels_of(tga), 1);
  const std::vector<Colour> colours = tga.kind() == Kind::map ? colour_map(tga, bytes) : std::vector<Colour>();
  const StbPixels raw = decode_stb(path, plain_header(tga), bytes.substr(tga.pixels_begin()));
  ImageFile image;
  image.values = oriented(path, tga, raw, colours);
  image.channels = default_channels(image.values.channels);
  return image;
}

} // namespace refraster
