#include "io/image/exr_header.h"

#include "io/file/text.h"
#include "io/image/image_reading.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

// The header of an OpenEXR file: magic number, version with flags, then attributes: name, type, size, value; an empty
// name ends them. https://openexr.com/en/latest/OpenEXRFileLayout.html
//
// It is walked here before OpenEXR sees it, because OpenEXR 3.1 takes memory by what the header says and only then
// meets the file's end, and because reading deep images has faults of its own (CVE-2023-5841).

namespace refraster {
namespace {

static_assert(std::endian::native == std::endian::little);

/// Deflate makes at most 1032 bytes of one, and the smallest channel has two.
constexpr std::uint64_t pixels_per_byte = 1032 / 2;
/// Memory that OpenEXR may take for rows or tiles that are not yet unpacked, beyond that of an image's size.
constexpr std::uint64_t max_buffer_bytes = 1 << 26;

/// Rows that are packed together, by the number of the compression.
constexpr std::uint64_t rows_by_compression[] = {1, 1, 1, 16, 32, 16, 32, 32, 32, 256};

/// The types of which every value has the same size in bytes.
constexpr std::pair<std::string_view, std::size_t> sizes_by_type[] = {{"box2i", 16},
                                                                      {"box2f", 16},
                                                                      {"chromaticities", 32},
                                                                      {"compression", 1},
                                                                      {"deepImageState", 1},
                                                                      {"double", 8},
                                                                      {"envmap", 1},
                                                                      {"float", 4},
                                                                      {"int", 4},
                                                                      {"keycode", 28},
                                                                      {"lineOrder", 1},
                                                                      {"m33f", 36},
                                                                      {"m33d", 72},
                                                                      {"m44f", 64},
                                                                      {"m44d", 128},
                                                                      {"rational", 8},
                                                                      {"tiledesc", 9},
                                                                      {"timecode", 8},
                                                                      {"v2i", 8},
                                                                      {"v2f", 8},
                                                                      {"v2d", 16},
                                                                      {"v3i", 12},
                                                                      {"v3f", 12},
                                                                      {"v3d", 24}};

class HeaderReader {
public:
  HeaderReader(const std::string& path, std::string_view bytes, const ImageRequest& request)
      : path_(path), bytes_(bytes), request_(request) {}

  ExrHeader read() {
    constexpr std::uint32_t tiled = 0x200, long_names = 0x400, deep = 0x800, several_parts = 0x1000;
    take(4); // the magic number
    const auto version = number<std::uint32_t>(take(4));
    if ((version & 0xff) > 2) fail("version", std::to_string(version & 0xff), "at most 2");
    if (version & (deep | several_parts)) fail("", "deep or several images in one file", "a flat one");
    if (version & ~(0xff | tiled | long_names)) fail("version", "an unknown flag", "a file of version 2");
    for (std::string_view name = take_text(); !name.empty(); name = take_text()) attribute(name);
    judge((version & tiled) != 0);
    result_.end = at_;
    return result_;
  }

private:
  [[noreturn]] void fail(std::string place, std::string found, std::string expected) const {
    throw InputError(InputFault{path_, 0, 0, std::move(place), std::move(found), std::move(expected)});
  }
  std::string_view take(std::size_t count) {
    if (bytes_.size() - at_ < count) throw truncated_image(path_);
    const std::string_view taken = bytes_.substr(at_, count);
    at_ += count;
    return taken;
  }
  /// Up to a zero byte, which is taken too.
  std::string_view take_text() {
    const std::size_t end = bytes_.find('\0', at_);
    if (end == std::string_view::npos) throw truncated_image(path_);
    const std::string_view text = bytes_.substr(at_, end - at_);
    if (text.size() > 255) fail("header", "a name of " + counted(text.size(), "byte"), "at most 255");
    at_ = end + 1;
    return text;
  }
  template <class Value>
  static Value number(std::string_view bytes, std::size_t at = 0) {
    Value value{};
    std::memcpy(&value, &bytes[at], sizeof value);
    return value;
  }

  void attribute(std::string_view name) {
    const std::string_view type = take_text();
    const auto size = number<std::int32_t>(take(4));
    if (size < 0) fail(one_line(name), "a size of " + std::to_string(size), "at least 0");
    const std::string_view value = take(static_cast<std::size_t>(size));
    require_size(name, type, value);
    const auto is = [&](std::string_view wanted_name, std::string_view wanted_type) {
      if (name == wanted_name && type != wanted_type) fail(one_line(name), in_quotes(type), std::string(wanted_type));
      return name == wanted_name;
    };
    if (is("channels", "chlist")) channels(value);
    else if (is("dataWindow", "box2i")) data_window(value);
    else if (is("compression", "compression"))
      is_compressed_ = true, result_.compression = static_cast<std::uint8_t>(value[0]);
    else if (is("tiles", "tiledesc"))
      result_.tile_width = number<std::uint32_t>(value), result_.tile_height = number<std::uint32_t>(value, 4);
    else if (is("type", "string") && value != "scanlineimage" && value != "tiledimage")
      fail("type", in_quotes(value), "scanlineimage or tiledimage");
  }

  /// OpenEXR reads a value by its type and goes on where that ended, whatever the size says: were it not the same, it
  /// would read another header than this. Other types are opaque to it, and read by their size.
  void require_size(std::string_view name, std::string_view type, std::string_view value) const {
    for (const auto& [known, size] : sizes_by_type)
      if (type == known && value.size() != size)
        fail(one_line(name), std::string(known) + " of " + counted(value.size(), "byte"), std::to_string(size));
    if (type == "preview") {
      const bool has_size = value.size() >= 8;
      const std::uint64_t pixels =
          has_size ? std::uint64_t{number<std::uint32_t>(value)} * number<std::uint32_t>(value, 4) : 0;
      if (!has_size || pixels > value.size() || value.size() != 8 + 4 * pixels)
        fail(one_line(name), "a preview that ends early", "a whole one");
    }
    if (type == "chlist" && name != "channels") fail(one_line(name), "a second list of channels", "one");
    for (const std::string_view unsafe : {"stringvector", "floatvector", "idmanifest"}) // none that an image needs
      if (type == unsafe) fail(one_line(name), "an attribute of type " + std::string(unsafe), "an image without");
  }

  void data_window(std::string_view value) {
    const auto side = [&](std::size_t low, std::size_t high) {
      // Coordinates are int32; a side that is not positive, and one that is too large, fail below.
      const std::int64_t length =
          std::int64_t{number<std::int32_t>(value, high)} - number<std::int32_t>(value, low) + 1;
      return static_cast<std::uint64_t>(std::max<std::int64_t>(length, 0));
    };
    result_.width = side(0, 8), result_.height = side(4, 12);
    result_.min_y = number<std::int32_t>(value, 4);
    check_image_size(path_, result_.width, result_.height, bytes_.size(), pixels_per_byte, request_);
  }

  /// Name, type, whether it is linear, three bytes of nothing, x and y sampling; an empty name ends them.
  void channels(std::string_view list) {
    constexpr std::size_t behind_name = 16;
    if (channels_ > 0) fail("channels", "a second list", "one");
    while (!list.starts_with('\0')) {
      const std::size_t end = list.find('\0');
      if (end == std::string_view::npos || end > 255 || list.size() - end < 1 + behind_name + 1)
        fail("channels", "a list that ends early", "a whole one");
      const std::string name = one_line(list.substr(0, end));
      list.remove_prefix(end + 1);
      const auto type = number<std::uint32_t>(list);
      if (type > 2) fail(name, "a channel of type " + std::to_string(type), "0 to 2");
      if (number<std::int32_t>(list, 8) != 1 || number<std::int32_t>(list, 12) != 1)
        fail(name, "a subsampled channel", "a value for every pixel");
      result_.bytes_a_pixel += type == 1 ? 2 : 4;
      ++channels_;
      list.remove_prefix(behind_name);
    }
    if (list.size() != 1) fail("channels", counted(list.size() - 1, "byte") + " behind the list", "none");
    if (channels_ > limit::image_channels.value)
      fail("", found_of(limit::image_channels, channels_), at_most(limit::image_channels));
  }

  void judge(bool is_tiled) {
    if (result_.width == 0) fail("dataWindow", "nothing", "the size of the image");
    if (channels_ == 0) fail("channels", "none", "at least 1");
    if (!is_compressed_) fail("compression", "nothing", "0 to 9");
    if (result_.compression >= std::size(rows_by_compression))
      fail("compression", std::to_string(result_.compression), "0 to 9");
    if (!is_tiled) result_.tile_width = result_.tile_height = 0; // such an attribute says nothing then
    else if (result_.tile_width == 0 || result_.tile_height == 0) fail("tiles", "nothing", "the size of a tile");
    const std::uint64_t image = result_.width * result_.height * result_.bytes_a_pixel;
    const std::uint64_t most = std::max(image, max_buffer_bytes) / result_.bytes_a_pixel;
    // Both factors are below 2^32.
    const std::uint64_t pixels =
        is_tiled ? result_.tile_width * result_.tile_height : result_.width * result_.rows_together();
    if (pixels > most)
      fail(is_tiled ? "tiles" : "compression", std::to_string(pixels) + " pixels that are packed together",
           "at most " + std::to_string(most) + " here");
  }

  const std::string& path_;
  std::string_view bytes_;
  const ImageRequest& request_;
  std::size_t at_ = 0;
  ExrHeader result_;
  bool is_compressed_ = false;
  std::size_t channels_ = 0;
};

} // namespace

std::uint64_t ExrHeader::rows_together() const {
  return rows_by_compression[compression];
}

ExrHeader read_exr_header(const std::string& path, std::string_view bytes, const ImageRequest& request) {
  return HeaderReader(path, bytes, request).read();
}

} // namespace refraster
