#include <refraster/files.h>
#include <refraster/notes.h>

#include "io/file/input_file.h"
#include "io/file/text.h"
#include "io/image/image_formats.h"

namespace refraster {

void check_image_size(const std::string& path, std::uint64_t width, std::uint64_t height, std::uint64_t file_bytes,
                      std::uint64_t max_pixels_per_byte, const ImageRequest& request) {
  const auto fail = [&](const std::string& expected) {
    throw InputError(
        InputFault{path, 0, 0, "", std::to_string(width) + " x " + std::to_string(height) + " pixels", expected});
  };
  if (width == 0 || height == 0) fail("at least 1 x 1");
  if (width > request.side.value || height > request.side.value) fail(at_most(request.side));
  if (width * height > limit::image_pixels.value) fail(at_most(limit::image_pixels));
  if (width * height > file_bytes * max_pixels_per_byte)
    fail("as many as a file of " + std::to_string(file_bytes) + " bytes can hold");
}

void need_image(const ImageRequest& request, const std::string& path, std::uint64_t pixels, int channels,
                std::uint64_t decoded_bytes) {
  request.memory.need(pixels * static_cast<std::uint64_t>(channels) * (sizeof(float) + decoded_bytes), path);
}

void refuse_image(const std::string& path, std::string place, std::string found, std::string expected) {
  throw InputError(InputFault{path, 0, 0, std::move(place), std::move(found), std::move(expected)});
}

InputError truncated_image(const std::string& path) {
  return InputError(InputFault{path, 0, 0, "", "a truncated image", "a whole one"});
}

std::vector<std::string> default_channels(int count) {
  if (count == 1) return {"Y"};
  if (count == 2) return {"Y", "A"};
  std::vector<std::string> names = {"R", "G", "B"};
  if (count > 3) names.emplace_back("A");
  for (int i = 4; i < count; ++i) names.push_back(std::to_string(i));
  return names;
}

namespace {
ImageFile read_image(const std::string& path, const ImageRequest& request) {
  if (auto fault = file_fault(path, "an image", limit::image_bytes.value)) throw InputError(std::move(*fault));
  format_of_content(path, read_prefix(path, 1024)); // before the whole is read, however large it is
  request.memory.need(file_size_bytes(path), path);
  const std::string bytes = read_file(path, "an image", limit::image_bytes.value);
  return format_of_content(path, bytes).read(path, bytes, request);
}
} // namespace

ImageFile read_image(const std::string& path, const MemoryBudget& memory) {
  return read_image(path, ImageRequest{memory});
}

Texture read_texture(const std::string& path, const MemoryBudget& memory, NoteList* notes) {
  const ImageFile image = read_image(path, ImageRequest{memory, limit::texture_side});
  if (notes) notes->add(image.notes);
  if (image.bits > 16)
    throw InputError(InputFault{path, 0, 0, "", "an image of floating-point numbers", "8 or 16 bits a channel"});
  Texture texture;
  texture.full_scale = image.full_scale;
  TextureLevel& level = texture.levels.emplace_back();
  level.width = image.values.width;
  level.height = image.values.height;
  memory.need(3 * sizeof(float) * image.values.values.size() / static_cast<std::size_t>(image.values.channels), path);
  level.rgb.reserve(3 * image.values.values.size() / static_cast<std::size_t>(image.values.channels));
  const bool grey = image.values.channels < 3;
  for (int y = level.height - 1; y >= 0; --y) // v goes up: row 0 of a texture is the last of the image
    for (int x = 0; x < level.width; ++x) {
      const float* const pixel = image.values.at(x, y);
      for (int c = 0; c < 3; ++c) level.rgb.push_back(pixel[grey ? 0 : c]);
    }
  return texture;
}

namespace {

/// The format to write this in. Throws InputError.
const ImageFormat& format_to_write(const std::string& path, const ImageContent& content) {
  const ImageFormat* const format = format_of_name(path);
  const std::string ending = "." + extension(path);
  if (!format || !writes_values(*format, content.values))
    refuse_image(path, "", "the extension \"" + ending + "\"", writable_extensions({content}));
  if (format->writes.contains(content.channels)) return *format;
  std::vector<std::string> counts;
  for (const int count : format->writes.counts)
    if (count > 0) counts.push_back(std::to_string(count));
  refuse_image(path, "", std::to_string(content.channels) + " channels",
               alternatives(counts) + " channels in " + "a file ending in " + ending);
}

} // namespace

void write_image(const std::string& path, const Image<std::uint8_t>& image, const WriteOptions& options) {
  format_to_write(path, {ImageValues::uint8, image.channels}).write_uint8(path, image, options);
}

void write_image(const std::string& path, const Image<std::uint16_t>& image, const WriteOptions& options) {
  format_to_write(path, {ImageValues::uint16, image.channels}).write_uint16(path, image, options);
}

void write_image(const std::string& path, const Image<std::uint32_t>& image, const WriteOptions& options) {
  format_to_write(path, {ImageValues::uint32, image.channels}).write_uint32(path, image, options);
}

void write_image(const std::string& path, const Image<float>& image, std::vector<std::string> channels,
                 const WriteOptions& options) {
  const ImageFormat& format = format_to_write(path, {ImageValues::floats, image.channels});
  if (channels.empty()) channels = default_channels(image.channels);
  if (static_cast<int>(channels.size()) != image.channels)
    refuse_image(path, "", std::to_string(image.channels) + " channels", "a name for every channel");
  format.write_floats(path, image, channels, options);
}

} // namespace refraster
