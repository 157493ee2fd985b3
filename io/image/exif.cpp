#include "io/image/exif.h"

#include <array>

namespace refraster {
namespace {

/// Whole numbers in either order of bytes; 0 beyond the end.
struct Tiff {
  std::string_view bytes;
  bool big_endian;

  std::uint32_t number(std::size_t at, std::size_t size) const {
    if (at > bytes.size() || size > bytes.size() - at) return 0;
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
      value = value << 8 | static_cast<std::uint8_t>(bytes[at + (big_endian ? i : size - 1 - i)]);
    return value;
  }
};

} // namespace

int exif_orientation(std::string_view tiff) {
  using namespace std::string_view_literals;
  constexpr std::uint32_t tag_orientation = 0x0112, type_short = 3;
  constexpr std::size_t entry_bytes = 12;
  const bool is_big_endian = tiff.starts_with("MM\0*"sv);
  if (!is_big_endian && !tiff.starts_with("II*\0"sv)) return 1;
  const Tiff data{tiff, is_big_endian};
  const std::size_t directory = data.number(4, 4), count = data.number(directory, 2);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t entry = directory + 2 + i * entry_bytes;
    if (data.number(entry, 2) != tag_orientation || data.number(entry + 2, 2) != type_short) continue;
    const std::uint32_t value = data.number(entry + 8, 2);
    return value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
  }
  return 1;
}

void note_orientation(ImageFile& image, const std::string& path, int orientation) {
  constexpr std::array<const char*, 9> to_see_it = {"", // of what is stored, what a viewer shows
                                                    "as stored",
                                                    "mirrored, left and right exchanged",
                                                    "turned by 180 degrees",
                                                    "mirrored, top and bottom exchanged",
                                                    "mirrored at the diagonal from the top left corner",
                                                    "turned by 90 degrees clockwise",
                                                    "mirrored at the diagonal from the top right corner",
                                                    "turned by 90 degrees counter-clockwise"};
  if (orientation == 1) return;
  const char* const how = to_see_it.at(static_cast<std::size_t>(orientation));
  image.notes.add({path, 0, "EXIF orientation " + std::to_string(orientation) + ", to be shown " + how,
                   "read as its rows are stored", 1});
}

} // namespace refraster
