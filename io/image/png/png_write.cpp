#include "io/image/png/png_write.h"

#include "io/file/atomic_file.h"
#include "io/image/image_formats.h"
#include "io/image/png/png_filter.h"
#include "io/parallel/pieces.h"
#include "raster/frame_context.h"

#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <new>
#include <span>
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

/// Strips that are made before any of them is written, for each thread: enough that none waits long for the last.
constexpr std::size_t strips_a_thread = 8;

/// Row y as a file has it. Samples of 16 bits come with their high byte first. The scratch holds what is not in memory.
template <class Value>
struct Scratch {
  std::vector<Value> values;
  std::vector<std::uint8_t> bytes;
};
const std::uint8_t* stored_row(const ImageRows<std::uint8_t>& image, int y, Scratch<std::uint8_t>& scratch) {
  return image.row(y, scratch.values);
}
const std::uint8_t* stored_row(const ImageRows<std::uint16_t>& image, int y, Scratch<std::uint16_t>& scratch) {
  const std::size_t samples = image.row_values();
  scratch.bytes.resize(2 * samples);
  const std::uint16_t* const row = image.row(y, scratch.values);
  for (std::size_t i = 0; i < samples; ++i) {
    scratch.bytes[2 * i] = static_cast<std::uint8_t>(row[i] >> 8);
    scratch.bytes[2 * i + 1] = static_cast<std::uint8_t>(row[i]);
  }
  return scratch.bytes.data();
}

/// The strips of an image, filtered, some at a time; before them in memory, the window that deflate looks back into.
template <class Value>
class FilteredStrips {
public:
  FilteredStrips(const ImageRows<Value>& image, std::size_t strips_at_a_time)
      : image_(image), pixel_bytes_(static_cast<std::size_t>(image.channels) * sizeof(Value)),
        row_bytes_(pixel_bytes_ * static_cast<std::size_t>(image.width)),
        strip_rows_(std::max<std::size_t>(1, strip_bytes / (1 + row_bytes_))),
        at_a_time_(std::min(strips_at_a_time, all())),
        bytes_(std::make_unique_for_overwrite<std::uint8_t[]>(
            window_bytes + std::min(at_a_time_ * strip_rows_, rows()) * (1 + row_bytes_))) {}

  /// Of the image.
  std::size_t all() const { return (rows() + strip_rows_ - 1) / strip_rows_; }
  /// Those that are in memory now: the first, and the one behind the last.
  std::size_t first() const { return first_; }
  std::size_t end() const { return std::min(first_ + at_a_time_, all()); }
  /// Goes on to the next ones, which are to be filtered then.
  void advance() {
    const std::size_t filled = begin(end()) - begin(first_), kept = std::min(window_bytes, before() + filled);
    std::memmove(bytes_.get() + window_bytes - kept, bytes_.get() + window_bytes + filled - kept, kept);
    first_ = end();
  }

  void filter(std::size_t strip) {
    RowFilter filter(row_bytes_, pixel_bytes_);
    Scratch<Value> scratch, scratch_above;
    const std::size_t first = strip * strip_rows_, end = std::min(first + strip_rows_, rows());
    const std::uint8_t* above = first == 0 ? nullptr : stored_row(image_, static_cast<int>(first) - 1, scratch_above);
    std::uint8_t* to = bytes_.get() + window_bytes + begin(strip) - begin(first_);
    for (std::size_t y = first; y < end; ++y, to += 1 + row_bytes_) {
      const std::uint8_t* const row = stored_row(image_, static_cast<int>(y), scratch);
      filter.filter(row, above, to);
      above = row;
      std::swap(scratch, scratch_above);
    }
  }
  /// A filtered strip, and how many bytes that are before it in the image are before it in memory, up to the window.
  std::span<const std::uint8_t> bytes(std::size_t strip) const {
    return {bytes_.get() + window_bytes + begin(strip) - begin(first_), begin(strip + 1) - begin(strip)};
  }
  std::size_t bytes_before(std::size_t strip) const { return std::min(begin(strip), window_bytes); }

private:
  std::size_t rows() const { return static_cast<std::size_t>(image_.height); }
  /// Where the bytes of a strip begin, counted from those of the image; of the one behind the last, where all end.
  std::size_t begin(std::size_t strip) const { return std::min(strip * strip_rows_, rows()) * (1 + row_bytes_); }
  std::size_t before() const { return std::min(begin(first_), window_bytes); }

  const ImageRows<Value>& image_;
  std::size_t pixel_bytes_, row_bytes_, strip_rows_, at_a_time_, first_ = 0;
  std::unique_ptr<std::uint8_t[]> bytes_;
};

/// Of a strip: what deflate makes of it, to stand behind that of the strip before; and its checksum.
struct PackedStrip {
  std::string bytes;
  uLong adler = 0;
  std::size_t unpacked_bytes = 0;
};

enum class Place { within, last };

PackedStrip pack(std::span<const std::uint8_t> bytes, std::size_t bytes_before, Place place,
                 const PngPacking& packing) {
  z_stream stream{};
  constexpr int raw = -15; // a window of 2^15 bytes, and no header: the file has one for all strips
  if (deflateInit2(&stream, packing.level, Z_DEFLATED, raw, memory_level, packing.strategy) != Z_OK)
    throw std::bad_alloc();
  const std::unique_ptr<z_stream, int (*)(z_stream*)> owner(&stream, deflateEnd);
  if (bytes_before > 0) deflateSetDictionary(&stream, bytes.data() - bytes_before, static_cast<uInt>(bytes_before));
  PackedStrip strip;
  strip.unpacked_bytes = bytes.size();
  constexpr std::size_t flush_bytes = 16; // an empty stored block, and the bits that it is aligned by: 5 or 6
  strip.bytes.resize(deflateBound(&stream, static_cast<uLong>(bytes.size())) + flush_bytes);
  stream.next_in = const_cast<Bytef*>(bytes.data()); // zlib reads it only
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(strip.bytes.data());
  stream.avail_out = static_cast<uInt>(strip.bytes.size());
  deflate(&stream, place == Place::last ? Z_FINISH : Z_SYNC_FLUSH);
  strip.bytes.resize(strip.bytes.size() - stream.avail_out);
  strip.adler = adler32_z(adler32(0, nullptr, 0), bytes.data(), bytes.size());
  return strip;
}

template <class Value>
std::string header(const ImageRows<Value>& image) {
  constexpr char colour_types[] = {0, 4, 2, 6}; // by channels: grey, with alpha, RGB, with alpha
  std::string bytes;
  append_big_endian(bytes, static_cast<std::uint32_t>(image.width));
  append_big_endian(bytes, static_cast<std::uint32_t>(image.height));
  bytes.push_back(static_cast<char>(8 * sizeof(Value)));
  bytes.push_back(colour_types[image.channels - 1]);
  return bytes + std::string(3, '\0'); // deflate, the five filters, not interlaced
}

/// Hands the bytes of the file to take(), piece by piece.
template <class Value, class Take>
void make_file(const ImageRows<Value>& image, const WriteOptions& options, const PngPacking& packing,
               const Take& take) {
  const int threads = thread_count({.threads = options.threads});
  FilteredStrips<Value> strips(image, strips_a_thread * static_cast<std::size_t>(threads));

  std::string piece = "\x89PNG\r\n\x1a\n";
  append_chunk(piece, "IHDR", {header(image)});
  if (options.curve == StatedCurve::srgb) append_chunk(piece, "sRGB", {"\0"sv}); // rendering intent: perceptual
  uLong adler = adler32(0, nullptr, 0);
  for (; strips.first() < strips.all(); strips.advance()) {
    const std::size_t first = strips.first(), count = strips.end() - first;
    for_pieces(threads, count, [&](std::size_t i, int) { strips.filter(first + i); });
    std::vector<PackedStrip> packed(count);
    for_pieces(threads, count, [&](std::size_t i, int) {
      const Place place = first + i + 1 == strips.all() ? Place::last : Place::within;
      packed[i] = pack(strips.bytes(first + i), strips.bytes_before(first + i), place, packing);
    });
    for (std::size_t i = 0; i < count; ++i) {
      const PackedStrip& strip = packed[i];
      adler = adler32_combine(adler, strip.adler, static_cast<z_off_t>(strip.unpacked_bytes));
      std::string checksum;
      if (first + i + 1 == strips.all()) append_big_endian(checksum, static_cast<std::uint32_t>(adler));
      // The header of zlib's format: deflate, a window of 32 KiB, no word on the level; a multiple of 31.
      append_chunk(piece, "IDAT", {first + i == 0 ? "\x78\x01"sv : ""sv, strip.bytes, checksum});
      take(piece);
      piece.clear();
    }
  }
  append_chunk(piece, "IEND", {});
  take(piece);
}

template <class Value>
std::string file_of(const Image<Value>& image, const WriteOptions& options, const PngPacking& packing) {
  std::string file;
  make_file(ImageRows(image), options, packing, [&](const std::string& piece) { file += piece; });
  return file;
}

template <class Value>
void write_to(const std::string& path, const ImageRows<Value>& image, const WriteOptions& options) {
  AtomicFile file(path);
  make_file(image, options, png_packing, [&](const std::string& piece) { file.write(piece); });
  file.commit();
}

} // namespace

const PngPacking png_packing{.level = 1, .strategy = Z_RLE};

std::string png_file(const Image<std::uint8_t>& image, const WriteOptions& options, const PngPacking& packing) {
  return file_of(image, options, packing);
}
std::string png_file(const Image<std::uint16_t>& image, const WriteOptions& options, const PngPacking& packing) {
  return file_of(image, options, packing);
}

void write_png(const std::string& path, const ImageRows<std::uint8_t>& image, const WriteOptions& options) {
  write_to(path, image, options);
}
void write_png(const std::string& path, const ImageRows<std::uint16_t>& image, const WriteOptions& options) {
  write_to(path, image, options);
}

} // namespace refraster
