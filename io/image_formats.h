#pragma once
// One file format each, for image_file.cpp.

#include "io/image_file.h"
#include "io/input_error.h"
#include "io/limits.h"

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

/// Throws InputError unless a file that begins like this may be one of read_stb's.
void check_stb_prefix(const std::string& path, std::string_view prefix);

/// What is said of a file that ends before its image does.
InputError truncated_image(const std::string& path);

/// PNG, JPEG, TGA, BMP.
ImageFile read_stb(const std::string& path, std::string_view bytes, const ImageRequest& request);
ImageFile read_hdr(const std::string& path, std::string_view bytes, const ImageRequest& request);
ImageFile read_pfm(const std::string& path, std::string_view bytes, const ImageRequest& request);
ImageFile read_exr(const std::string& path, std::string_view bytes, const ImageRequest& request);

/// How many pixels a byte of a PNG, JPEG, BMP or TGA may stand for. Throws InputError for what stb_image must not see:
/// a chunk of a PNG that is longer than the file; a BMP without all its pixels, with an index beyond its palette, or of
/// OS/2 with a palette, of which stb_image forgets four colours.
std::uint64_t check_before_stb(const std::string& path, std::string_view bytes, const ImageRequest& request);

/// What OpenEXR must not see: see read_exr_header; and a file that lacks rows or tiles, or in which one of them does
/// not fill its place: OpenEXR 3.1 takes the rest of it from memory. Throws InputError.
void check_before_exr(const std::string& path, std::string_view bytes, const ImageRequest& request);

void write_hdr(const std::string& path, const Image<float>& image);
void write_pfm(const std::string& path, const Image<float>& image);
void write_exr(const std::string& path, const Image<float>& image, const std::vector<std::string>& channels);

} // namespace refraster
