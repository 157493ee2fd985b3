#pragma once
// The image formats: one closed list. Reading, writing, what file names may end in, messages, help texts, the
// extensions of AOVs and the table of docs/image-formats.md follow from it.
// To add a format: a reader, and a writer if there is to be one, in a file of their own; declared and listed here; that
// file's name in CMakeLists.txt. Tests (tests/unit/io/test_image_formats.cpp) name what else it needs.

#include <refraster/files.h>

#include "io/image/image_reading.h"
#include "io/image/image_rows.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace refraster {

/// What the values of an image file are: whole numbers, floating-point numbers, or, as the file says, one of the two.
enum class StoredValues { integers, floats, either };

/// What the values of an image to be written are: whole numbers of 8, 16 or 32 bits, or floats of 32.
enum class ImageValues { uint8, uint16, uint32, floats };

/// Each reads the bytes of a whole file; InputError says what is wrong with them.
using ImageReader = ImageFile (*)(const std::string& path, std::string_view bytes, const ImageRequest& request);
/// Writes a file as a whole or not at all. Throws OutputError.
template <class Value>
using IntegerWriter = void (*)(const std::string& path, const ImageRows<Value>& image, const WriteOptions& options);
/// Writes a file of floats likewise; a format that names its channels uses `channels`, as many as the image has.
using FloatWriter = void (*)(const std::string& path, const ImageRows<float>& image,
                             const std::vector<std::string>& channels, const WriteOptions& options);

ImageFile read_png(const std::string& path, std::string_view bytes, const ImageRequest& request);
ImageFile read_jpeg(const std::string& path, std::string_view bytes, const ImageRequest& request);
ImageFile read_bmp(const std::string& path, std::string_view bytes, const ImageRequest& request);
ImageFile read_tga(const std::string& path, std::string_view bytes, const ImageRequest& request);
ImageFile read_hdr(const std::string& path, std::string_view bytes, const ImageRequest& request);
ImageFile read_pfm(const std::string& path, std::string_view bytes, const ImageRequest& request);
ImageFile read_exr(const std::string& path, std::string_view bytes, const ImageRequest& request);
ImageFile read_npy(const std::string& path, std::string_view bytes, const ImageRequest& request);

/// Whether a file that begins like this can be a TGA, which has no signature.
bool may_be_tga(std::string_view prefix);

void write_png(const std::string& path, const ImageRows<std::uint8_t>& image, const WriteOptions& options);
void write_png(const std::string& path, const ImageRows<std::uint16_t>& image, const WriteOptions& options);
void write_jpeg(const std::string& path, const ImageRows<std::uint8_t>& image, const WriteOptions& options);
void write_npy(const std::string& path, const ImageRows<std::uint8_t>& image, const WriteOptions& options);
void write_npy(const std::string& path, const ImageRows<std::uint16_t>& image, const WriteOptions& options);
void write_npy(const std::string& path, const ImageRows<std::uint32_t>& image, const WriteOptions& options);
void write_npy(const std::string& path, const ImageRows<float>& image, const std::vector<std::string>& channels,
               const WriteOptions& options);
void write_hdr(const std::string& path, const ImageRows<float>& image, const std::vector<std::string>& channels,
               const WriteOptions& options);
void write_pfm(const std::string& path, const ImageRows<float>& image, const std::vector<std::string>& channels,
               const WriteOptions& options);
void write_exr(const std::string& path, const ImageRows<float>& image, const std::vector<std::string>& channels,
               const WriteOptions& options);

/// Numbers of channels that a format can write.
struct ChannelCounts {
  std::array<int, 4> counts; // 0: no further one

  static constexpr int any = -1;

  bool operator==(const ChannelCounts&) const = default;
  constexpr bool contains(int channels) const {
    return std::any_of(counts.begin(), counts.end(),
                       [=](int count) { return count == any || (count != 0 && count == channels); });
  }
};

struct ImageFormat {
  std::string_view name;                           // in messages
  StoredValues values;                             // that it stores
  std::array<std::string_view, 2> extensions;      // of file names, in lower case; the first is the usual one
  std::array<std::string_view, 2> signatures = {}; // a file begins with one of them; none: `may_be` says it
  bool (*may_be)(std::string_view prefix) = {};    // asked where no signature of any format, read or not, is found
  ImageReader read;
  // Null: none are written.
  IntegerWriter<std::uint8_t> write_uint8 = {};
  IntegerWriter<std::uint16_t> write_uint16 = {};
  IntegerWriter<std::uint32_t> write_uint32 = {};
  FloatWriter write_floats = {};
  bool wants_all_rows = false; // in memory, to be written
  ChannelCounts writes = {};   // of any of these; empty: it is not written
};

/// In the order in which messages list them.
inline constexpr ImageFormat image_formats[] = {
    {.name = "PNG",
     .values = StoredValues::integers,
     .extensions = {"png"},
     .signatures = {"\x89PNG\r\n\x1a\n"},
     .read = read_png,
     .write_uint8 = write_png,
     .write_uint16 = write_png,
     .writes = {1, 2, 3, 4}},
    {.name = "JPEG",
     .values = StoredValues::integers,
     .extensions = {"jpg", "jpeg"},
     .signatures = {"\xff\xd8"},
     .read = read_jpeg,
     .write_uint8 = write_jpeg,
     .wants_all_rows = true,
     .writes = {3}},
    {.name = "BMP", .values = StoredValues::integers, .extensions = {"bmp"}, .signatures = {"BM"}, .read = read_bmp},
    {.name = "TGA", .values = StoredValues::integers, .extensions = {"tga"}, .may_be = may_be_tga, .read = read_tga},
    {.name = "Radiance HDR",
     .values = StoredValues::floats,
     .extensions = {"hdr"},
     .signatures = {"#?RADIANCE\n", "#?RGBE\n"},
     .read = read_hdr,
     .write_floats = write_hdr,
     .writes = {3}},
    {.name = "PFM",
     .values = StoredValues::floats,
     .extensions = {"pfm"},
     .signatures = {"PF", "Pf"},
     .read = read_pfm,
     .write_floats = write_pfm,
     .writes = {1, 3}},
    {.name = "OpenEXR",
     .values = StoredValues::floats,
     .extensions = {"exr"},
     .signatures = {"\x76\x2f\x31\x01"},
     .read = read_exr,
     .write_floats = write_exr,
     .writes = {ChannelCounts::any}},
    {.name = "NumPy",
     .values = StoredValues::either,
     .extensions = {"npy"},
     .signatures = {"\x93NUMPY"},
     .read = read_npy,
     .write_uint8 = write_npy,
     .write_uint16 = write_npy,
     .write_uint32 = write_npy,
     .write_floats = write_npy,
     .writes = {ChannelCounts::any}},
};

/// The format whose signature these bytes begin with, or null.
const ImageFormat* format_with_signature(std::string_view prefix);

/// The format of a file that begins like this, as far as 1024 bytes of it tell. Throws InputError for an unknown one.
const ImageFormat& format_of_content(const std::string& path, std::string_view prefix);

/// The format that a file name says by its extension, in any case, whether it can be written or not; or null.
const ImageFormat* format_of_name(const std::string& path);

/// A kind of values that images are written with.
struct ImageDepth {
  ImageValues values;
  std::string_view name;                         // in messages
  int asked_bits;                                // by which an option asks for it; 0: none does
  bool (*is_written)(const ImageFormat& format); // whether a format has a writer of it, of whatever channels
};
inline constexpr ImageDepth image_depths[] = {
    {ImageValues::uint8, "8 bits", 8, [](const ImageFormat& format) { return format.write_uint8 != nullptr; }},
    {ImageValues::uint16, "16 bits", 16, [](const ImageFormat& format) { return format.write_uint16 != nullptr; }},
    {ImageValues::uint32, "32 bits", 0, [](const ImageFormat& format) { return format.write_uint32 != nullptr; }},
    {ImageValues::floats, "floats", 32, [](const ImageFormat& format) { return format.write_floats != nullptr; }},
};

/// Of one kind.
constexpr const ImageDepth& depth_of(ImageValues values) {
  return *std::find_if(std::begin(image_depths), std::end(image_depths),
                       [=](const ImageDepth& depth) { return depth.values == values; });
}

/// What an image to be written consists of.
struct ImageContent {
  ImageValues values;
  int channels;
};
inline constexpr ImageContent rgb8_image{ImageValues::uint8, 3}, float_rgb_image{ImageValues::floats, 3},
    float_grey_image{ImageValues::floats, 1};

/// Whether a format has a writer of such values, of whatever channels.
constexpr bool writes_values(const ImageFormat& format, ImageValues values) {
  return std::any_of(std::begin(image_depths), std::end(image_depths),
                     [&](const ImageDepth& depth) { return depth.values == values && depth.is_written(format); });
}

constexpr bool can_write(const ImageFormat& format, const ImageContent& content) {
  return writes_values(format, content.values) && format.writes.contains(content.channels);
}

/// The format that a file of this name is written in by its extension; null if that one cannot hold any of `contents`.
const ImageFormat* format_to_write(const std::string& path, std::initializer_list<ImageContent> contents);

/// As write_image of <refraster/files.h>: the same bytes for the same values, which need not be in memory all at once
/// but for JPEG. Throws OutputError; InputError for another extension or number of channels, and what reading rows
/// throws.
void write_rows(const std::string& path, const ImageRows<std::uint8_t>& image, const WriteOptions& options);
void write_rows(const std::string& path, const ImageRows<std::uint16_t>& image, const WriteOptions& options);
void write_rows(const std::string& path, const ImageRows<std::uint32_t>& image, const WriteOptions& options);
void write_rows(const std::string& path, const ImageRows<float>& image, std::vector<std::string> channels,
                const WriteOptions& options);

/// ".hdr, .pfm, .exr or .npy": the extensions of the formats that can hold any of `contents`.
std::string writable_extensions(std::initializer_list<ImageContent> contents);

/// "PNG, JPEG, BMP, TGA, Radiance HDR, PFM, OpenEXR or NumPy": the formats that are read.
std::string readable_formats();

/// ".pfm": the extension of the images of floats, of 1 and of 3 channels, that stand beside an image of this name: its
/// own where its format can hold both, else that of the first format that can.
std::string float_extension_beside(const std::string& path);

} // namespace refraster
