#include "io/image/exr_header.h"
#include "io/image/image_reading.h"

#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <vector>

namespace refraster {
namespace {

// Numbers of the compressions that are looked into. The others check for themselves.
constexpr std::uint8_t none = 0, run_lengths = 1, zip_row = 2, zip_rows = 3;

/// Behind the header lies a table: for each chunk of rows, or for each tile of level 0, from left to right and then
/// down, the byte of the file where it begins. A chunk: its coordinates, its size, its data.
class ChunkReader {
public:
  ChunkReader(const std::string& path, std::string_view bytes, const ExrHeader& header)
      : path_(path), bytes_(bytes), header_(header) {}

  void check() {
    if (header_.tile_width > 0) {
      for (std::uint64_t y = 0, number = 0; y * header_.tile_height < header_.height; ++y)
        for (std::uint64_t x = 0; x * header_.tile_width < header_.width; ++x, ++number) {
          const std::int32_t coordinates[] = {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), 0, 0};
          chunk(number, coordinates, std::min(header_.tile_width, header_.width - x * header_.tile_width),
                std::min(header_.tile_height, header_.height - y * header_.tile_height));
        }
    } else {
      for (std::uint64_t y = 0, number = 0; y < header_.height; y += header_.rows_together(), ++number) {
        const std::int32_t first = static_cast<std::int32_t>(header_.min_y + static_cast<std::int64_t>(y));
        chunk(number, std::span(&first, 1), header_.width, std::min(header_.rows_together(), header_.height - y));
      }
    }
  }

private:
  std::string_view part(std::uint64_t at, std::uint64_t size) const {
    if (at > bytes_.size() || size > bytes_.size() - at) throw truncated_image(path_);
    return bytes_.substr(at, size);
  }
  template <class Value>
  Value number_at(std::uint64_t at) const {
    Value value{};
    std::memcpy(&value, part(at, sizeof value).data(), sizeof value);
    return value;
  }

  void chunk(std::uint64_t number, std::span<const std::int32_t> coordinates, std::uint64_t columns,
             std::uint64_t rows) {
    auto at = number_at<std::uint64_t>(header_.end + sizeof(std::uint64_t) * number);
    if (at == 0) throw truncated_image(path_); // never written
    const auto fail = [&](std::string found, std::string expected) {
      throw InputError(
          InputFault{path_, 0, 0, "chunk " + std::to_string(number), std::move(found), std::move(expected)});
    };
    for (const std::int32_t expected : coordinates) {
      const auto found = number_at<std::int32_t>(at);
      if (found != expected) fail("coordinate " + std::to_string(found), std::to_string(expected));
      at += sizeof found;
    }
    const std::string_view data = part(at + sizeof(std::uint32_t), number_at<std::uint32_t>(at));
    const std::uint64_t expected = columns * rows * header_.bytes_a_pixel;
    if (const std::uint64_t found = unpacked_bytes(data, expected); found != expected)
      fail(std::to_string(found) + " bytes of pixels", std::to_string(expected));
  }

  /// Of data that make `expected` bytes if all is well. What is not smaller than that is not packed.
  std::uint64_t unpacked_bytes(std::string_view data, std::uint64_t expected) {
    if (data.size() >= expected || header_.compression == none) return data.size();
    switch (header_.compression) {
    case run_lengths:
      return run_length_bytes(data);
    case zip_row:
    case zip_rows:
      return zip_bytes(data, expected);
    default:
      return expected;
    }
  }

  /// A count n >= 0 and the byte that is there n + 1 times, or n < 0 and -n bytes.
  static std::uint64_t run_length_bytes(std::string_view data) {
    std::uint64_t sum = 0;
    for (std::size_t at = 0; at < data.size();) {
      const int count = static_cast<signed char>(data[at]);
      sum += static_cast<std::uint64_t>(count < 0 ? -count : count + 1);
      at += static_cast<std::size_t>(count < 0 ? 1 - count : 2);
      if (at > data.size()) return 0;
    }
    return sum;
  }

  std::uint64_t zip_bytes(std::string_view data, std::uint64_t expected) {
    unpacked_.resize(expected);
    uLongf size = unpacked_.size();
    const int status = uncompress(unpacked_.data(), &size, reinterpret_cast<const Bytef*>(data.data()), data.size());
    return status == Z_OK ? size : 0;
  }

  const std::string& path_;
  std::string_view bytes_;
  const ExrHeader& header_;
  std::vector<Bytef> unpacked_;
};

} // namespace

void check_before_exr(const std::string& path, std::string_view bytes, const ImageRequest& request) {
  const ExrHeader header = read_exr_header(path, bytes, request);
  ChunkReader(path, bytes, header).check();
}

} // namespace refraster
