#pragma once
// What the readers of image formats share.

#include <refraster/files.h>
#include <refraster/notes.h>

#include "io/file/limits.h"

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

/// Names of channels: Y; Y A; R G B; R G B A, and the further ones by their numbers, from 4.
std::vector<std::string> default_channels(int count);

/// What is said of a file that ends before its image does.
InputError truncated_image(const std::string& path);

/// Throws InputError with one fault: at `place` of the file, "" for the file as a whole.
[[noreturn]] void refuse_image(const std::string& path, std::string place, std::string found, std::string expected);

/// 1 to 4 channels of 8 bits as stb_image gives them: row 0 at the top, channels interleaved.
struct StbPixels {
  std::unique_ptr<std::uint8_t, void (*)(void*)> values;
  int width, height, channels;
};

/// Decodes a BMP or TGA of which `header` is all that stands before the pixels. stb_image must agree with it; the
/// callers make headers of the plainest kind. Throws InputError if pixels are missing; std::bad_alloc.
StbPixels decode_stb(const std::string& path, std::string_view header, std::string_view pixels);

} // namespace refraster
