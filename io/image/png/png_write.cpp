#include "io/image/png/png_write.h"

#include "io/file/atomic_file.h"
#include "io/image/image_formats.h"
#include "io/image/png/png_filter.h"
#include "io/parallel/pieces.h"
#include "raster/frame_context.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <new>
#include <string_view>
#include <utility>
#include <vector>

namespace refraster {
namespace {

using namespace std::string_view_literals;

/// Filtered bytes that are packed together. More of them pack a little better, fewer occupy more threads: a strip
/// begins with the codes of none before it, and ends with 5 bytes that say so. At 256 KiB that costs less than 1 in
/// 1000, and an image of 1080p has 24 strips.
constexpr std::size_t strip_bytes = std::size_t{1} << 18;
/// How far back deflate looks (RFC 1951, 2).
constexpr std::size_t window_bytes = 32768;
/// The tables of one stream: zlib's largest, 256 KiB, which is also the fastest.
constexpr int memory_level = 9;

void append_big_endian(std::string& to, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) to.push_back(static_cast<char>(value >> shift & 0xff));
}

const Bytef* zlib_bytes(const char* bytes) {
  return reinterpret_cast<const Bytef*>(bytes);
}

/// Length, type, data, and the CRC of the two: of data that come in pieces.
void append_chunk(std::string& to, std::string_view type, std::initializer_list<std::string_view> data) {
  std::size_t size = 0;
  for (const std::string_view piece : data) size += piece.size();
  append_big_endian(to, static_cast<std::uint32_t>(size));
  const std::size_t checked = to.size();
  to += type;
  for (const std::string_view piece : data) to += piece;
  append_big_endian(to, static_cast<std::uint32_t>(crc32_z(0, zlib_bytes(to.data() + checked), to.size() - checked)));
}

/// Row y as a file has it. Samples of 16 bits come with their high byte first; `scratch` holds them.
const std::uint8_t* stored_row(const Image<std::uint8_t>& image, int y, std::vector<std::uint8_t>&) {
  return image.at(0, y);
}
const std::uint8_t* stored_row(const Image<std::uint16_t>& image, int y, std::vector<std::uint8_t>& scratch) {
  const std::size_t samples = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
  scratch.resize(2 * samples);
  const std::uint16_t* const row = image.at(0, y);
  for (std::size_t i = 0; i < samples; ++i) {
    scratch[2 * i] = static_cast<std::uint8_t>(row[i] >> 8);
    scratch[2 * i + 1] = static_cast<std::uint8_t>(row[i]);
  }
  return scratch.data();
}

/// All rows, filtered; and where they are cut.
template <class Value>
class FilteredRows {
public:
  explicit FilteredRows(const Image<Value>& image)
      : image_(image), pixel_bytes_(static_cast<std::size_t>(image.channels) * sizeof(Value)),
        row_bytes_(pixel_bytes_ * static_cast<std::size_t>(image.width)),
        strip_rows_(std::max<std::size_t>(1, strip_bytes / (1 + row_bytes_))),
        bytes_(std::make_unique_for_overwrite<std::uint8_t[]>(size())) {}

  std::size_t strips() const { return (rows() + strip_rows_ - 1) / strip_rows_; }
  const std::uint8_t* data() const { return bytes_.get(); }
  /// Where the bytes of a strip begin; of the one behind the last, where all end.
  std::size_t begin(std::size_t strip) const { return std::min(strip * strip_rows_, rows()) * (1 + row_bytes_); }

  void filter(std::size_t strip) {
    RowFilter filter(row_bytes_, pixel_bytes_);
    std::vector<std::uint8_t> scratch, scratch_above;
    const std::size_t first = strip * strip_rows_, end = std::min(first + strip_rows_, rows());
    const std::uint8_t* above = first == 0 ? nullptr : stored_row(image_, static_cast<int>(first) - 1, scratch_above);
    for (std::size_t y = first; y < end; ++y) {
      const std::uint8_t* const row = stored_row(image_, static_cast<int>(y), scratch);
      filter.filter(row, above, bytes_.get() + y * (1 + row_bytes_));
      above = row;
      std::swap(scratch, scratch_above);
    }
  }

private:
  std::size_t rows() const { return static_cast<std::size_t>(image_.height); }
  std::size_t size() const { return rows() * (1 + row_bytes_); }

  const Image<Value>& image_;
  std::size_t pixel_bytes_, row_bytes_, strip_rows_;
  std::unique_ptr<std::uint8_t[]> bytes_;
};

/// Of a strip: what deflate makes of it, to stand behind that of the strip before; and its checksum.
struct PackedStrip {
  std::string bytes;
  uLong adler = 0;
  std::size_t unpacked_bytes = 0;
};

enum class Place { within, last };

PackedStrip pack(const std::uint8_t* all, std::size_t begin, std::size_t end, Place place, const PngPacking& packing) {
  z_stream stream{};
  constexpr int raw = -15; // a window of 2^15 bytes, and no header: the file has one for all strips
  if (deflateInit2(&stream, packing.level, Z_DEFLATED, raw, memory_level, packing.strategy) != Z_OK)
    throw std::bad_alloc();
  const std::unique_ptr<z_stream, int (*)(z_stream*)> owner(&stream, deflateEnd);
  const std::size_t before = std::min(begin, window_bytes);
  if (before > 0) deflateSetDictionary(&stream, all + begin - before, static_cast<uInt>(before));
  PackedStrip strip;
  strip.unpacked_bytes = end - begin;
  constexpr std::size_t flush_bytes = 16; // an empty stored block, and the bits that it is aligned by: 5 or 6
  strip.bytes.resize(deflateBound(&stream, static_cast<uLong>(end - begin)) + flush_bytes);
  stream.next_in = const_cast<Bytef*>(all + begin); // zlib reads it only
  stream.avail_in = static_cast<uInt>(end - begin);
  stream.next_out = reinterpret_cast<Bytef*>(strip.bytes.data());
  stream.avail_out = static_cast<uInt>(strip.bytes.size());
  deflate(&stream, place == Place::last ? Z_FINISH : Z_SYNC_FLUSH);
  strip.bytes.resize(strip.bytes.size() - stream.avail_out);
  strip.adler = adler32_z(adler32(0, nullptr, 0), all + begin, end - begin);
  return strip;
}

template <class Value>
std::string header(const Image<Value>& image) {
  constexpr char colour_types[] = {0, 4, 2, 6}; // by channels: grey, with alpha, RGB, with alpha
  std::string bytes;
  append_big_endian(bytes, static_cast<std::uint32_t>(image.width));
  append_big_endian(bytes, static_cast<std::uint32_t>(image.height));
  bytes.push_back(static_cast<char>(8 * sizeof(Value)));
  bytes.push_back(colour_types[image.channels - 1]);
  return bytes + std::string(3, '\0'); // deflate, the five filters, not interlaced
}

template <class Value>
std::string file_of(const Image<Value>& image, const WriteOptions& options, const PngPacking& packing) {
  FilteredRows<Value> rows(image);
  const std::size_t strips = rows.strips();
  const int threads = thread_count({.threads = options.threads});
  for_pieces(threads, strips, [&](std::size_t i, int) { rows.filter(i); });
  std::vector<PackedStrip> packed(strips);
  for_pieces(threads, strips, [&](std::size_t i, int) {
    packed[i] =
        pack(rows.data(), rows.begin(i), rows.begin(i + 1), i + 1 == strips ? Place::last : Place::within, packing);
  });

  std::string file = "\x89PNG\r\n\x1a\n";
  append_chunk(file, "IHDR", {header(image)});
  if (options.curve == StatedCurve::srgb) append_chunk(file, "sRGB", {"\0"sv}); // rendering intent: perceptual
  uLong adler = adler32(0, nullptr, 0);
  for (std::size_t i = 0; i < strips; ++i) {
    const PackedStrip& strip = packed[i];
    adler = adler32_combine(adler, strip.adler, static_cast<z_off_t>(strip.unpacked_bytes));
    std::string checksum;
    if (i + 1 == strips) append_big_endian(checksum, static_cast<std::uint32_t>(adler));
    // The header of zlib's format: deflate, a window of 32 KiB, no word on the level; a multiple of 31.
    append_chunk(file, "IDAT", {i == 0 ? "\x78\x01"sv : ""sv, strip.bytes, checksum});
    packed[i] = {};
  }
  append_chunk(file, "IEND", {});
  return file;
}

} // namespace

const PngPacking png_packing{.level = 1, .strategy = Z_RLE};

std::string png_file(const Image<std::uint8_t>& image, const WriteOptions& options, const PngPacking& packing) {
  return file_of(image, options, packing);
}
std::string png_file(const Image<std::uint16_t>& image, const WriteOptions& options, const PngPacking& packing) {
  return file_of(image, options, packing);
}

void write_png(const std::string& path, const Image<std::uint8_t>& image, const WriteOptions& options) {
  write_file(path, png_file(image, options));
}
void write_png(const std::string& path, const Image<std::uint16_t>& image, const WriteOptions& options) {
  write_file(path, png_file(image, options));
}

} // namespace refraster
