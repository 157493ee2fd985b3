#pragma once
// One file format each, for image_file.cpp.

#include "io/file/input_error.h"
#include "io/file/limits.h"
#include "io/image/image_file.h"

#include <memory>
#include <string_view>

namespace refraster {

/// What an image is read for.
struct ImageRequest {
  const MemoryBudget& memory;
  const Limit& side = limit::image_side;
};

/// Asks for what an image of so many pixels takes as floats, and beside them as a decoder gives it.
void need_image(const ImageRequest& request, const std::string& path, std::uint64_t pixels, int channels,
                std::uint64_t decoded_bytes);

/// Throws InputError if the declared size is 0, beyond the limits, or more than so many file bytes can hold.
void check_image_size(const std::string& path, std::uint64_t width, std::uint64_t height, std::uint64_t file_bytes,
                      std::uint64_t max_pixels_per_byte, const ImageRequest& request);

/// The names of 1 to 4 channels.
std::vector<std::string> default_channels(int count);

/// What is said of a file that ends before its image does.
InputError truncated_image(const std::string& path);

/// Throws InputError with one fault: at `place` of the file, "" for the file as a whole.
[[noreturn]] void refuse_image(const std::string& path, std::string place, std::string found, std::string expected);

/// Each reads the bytes of a whole file; InputError says what is wrong with them.
using ImageReader = ImageFile (*)(const std::string& path, std::string_view bytes, const ImageRequest& request);

/// The reader of files that begin like this, as far as 1024 bytes of them tell. Throws InputError for an unknown type.
ImageReader image_reader(const std::string& path, std::string_view prefix);

ImageFile read_png(const std::string& path, std::string_view bytes, const ImageRequest& request);
ImageFile read_jpeg(const std::string& path, std::string_view bytes, const ImageRequest& request);
ImageFile read_bmp(const std::string& path, std::string_view bytes, const ImageRequest& request);
ImageFile read_tga(const std::string& path, std::string_view bytes, const ImageRequest& request);
ImageFile read_hdr(const std::string& path, std::string_view bytes, const ImageRequest& request);
ImageFile read_pfm(const std::string& path, std::string_view bytes, const ImageRequest& request);
ImageFile read_exr(const std::string& path, std::string_view bytes, const ImageRequest& request);

/// Whether a file that begins like this can be a TGA, which has no signature.
bool may_be_tga(std::string_view prefix);

/// 1 to 4 channels of 8 bits as stb_image gives them: row 0 at the top, channels interleaved.
struct StbPixels {
  std::unique_ptr<std::uint8_t, void (*)(void*)> values;
  int width, height, channels;
};

/// Decodes a BMP or TGA of which `header` is all that stands before the pixels. stb_image must agree with it; the
/// callers make headers of the plainest kind. Throws InputError if pixels are missing; std::bad_alloc.
StbPixels decode_stb(const std::string& path, std::string_view header, std::string_view pixels);

/// What OpenEXR must not see: see read_exr_header; and a file that lacks rows or tiles, or in which one of them does
/// not fill its place: OpenEXR 3.1 takes the rest of it from memory. Throws InputError.
void check_before_exr(const std::string& path, std::string_view bytes, const ImageRequest& request);

void write_hdr(const std::string& path, const Image<float>& image);
void write_pfm(const std::string& path, const Image<float>& image);
void write_exr(const std::string& path, const Image<float>& image, const std::vector<std::string>& channels);

} // namespace refraster
