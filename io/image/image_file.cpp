#include <refraster/files.h>
#include <refraster/notes.h>

#include "io/file/input_file.h"
#include "io/file/text.h"
#include "io/image/image_formats.h"

#include <array>

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

namespace {

/// A texture of what rgb_of(pixel, channels) makes of an image's pixels.
template <class RgbOf>
Texture texture_of(const std::string& path, const MemoryBudget& memory, NoteList* notes, const RgbOf& rgb_of) {
  const ImageFile image = read_image(path, ImageRequest{memory, limit::texture_side});
  if (notes) notes->add(image.notes);
  if (image.bits > 16)
    throw InputError(InputFault{path, 0, 0, "", "an image of floating-point numbers", "8 or 16 bits a channel"});
  Texture texture;
  texture.full_scale = image.full_scale;
  TextureLevel& level = texture.levels.emplace_back();
  level.width = image.values.width;
  level.height = image.values.height;
  const int channels = image.values.channels;
  memory.need(3 * sizeof(float) * image.values.values.size() / static_cast<std::size_t>(channels), path);
  level.rgb.reserve(3 * image.values.values.size() / static_cast<std::size_t>(channels));
  for (int y = level.height - 1; y >= 0; --y) // v goes up: row 0 of a texture is the last of the image
    for (int x = 0; x < level.width; ++x)
      for (const float value : rgb_of(image.values.at(x, y), channels, image.full_scale)) level.rgb.push_back(value);
  return texture;
}

float luminance(float r, float g, float b) {
  if (r == g && g == b) return r; // the weights add up to 1, but for their roundings
  return static_cast<float>(0.2126 * static_cast<double>(r) + 0.7152 * static_cast<double>(g) +
                            0.0722 * static_cast<double>(b));
}

/// Of a pixel of 1 (grey), 2 (grey, alpha), 3 (RGB) or 4 channels (RGB, alpha).
float channel_value(const float* pixel, int channels, double full_scale, ScalarChannel channel) {
  const bool has_alpha = channels % 2 == 0, grey = channels < 3;
  switch (channel) {
  case ScalarChannel::automatic:
    return channel_value(pixel, channels, full_scale, has_alpha ? ScalarChannel::alpha : ScalarChannel::luminance);
  case ScalarChannel::red:
    return pixel[0];
  case ScalarChannel::green:
    return pixel[grey ? 0 : 1];
  case ScalarChannel::blue:
    return pixel[grey ? 0 : 2];
  case ScalarChannel::alpha:
    return has_alpha ? pixel[channels - 1] : static_cast<float>(full_scale);
  case ScalarChannel::luminance:
    return grey ? pixel[0] : luminance(pixel[0], pixel[1], pixel[2]);
  }
  return 0;
}

} // namespace

Texture read_texture(const std::string& path, const MemoryBudget& memory, NoteList* notes) {
  return texture_of(path, memory, notes, [](const float* pixel, int channels, double) {
    const bool grey = channels < 3;
    return std::array{pixel[0], pixel[grey ? 0 : 1], pixel[grey ? 0 : 2]};
  });
}

Texture read_scalar_texture(const std::string& path, ScalarChannel channel, const MemoryBudget& memory,
                            NoteList* notes) {
  return texture_of(path, memory, notes, [channel](const float* pixel, int channels, double full_scale) {
    const float value = channel_value(pixel, channels, full_scale, channel);
    return std::array{value, value, value};
  });
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

void write_rows(const std::string& path, const ImageRows<std::uint8_t>& image, const WriteOptions& options) {
  format_to_write(path, {ImageValues::uint8, image.channels}).write_uint8(path, image, options);
}
void write_rows(const std::string& path, const ImageRows<std::uint16_t>& image, const WriteOptions& options) {
  format_to_write(path, {ImageValues::uint16, image.channels}).write_uint16(path, image, options);
}
void write_rows(const std::string& path, const ImageRows<std::uint32_t>& image, const WriteOptions& options) {
  format_to_write(path, {ImageValues::uint32, image.channels}).write_uint32(path, image, options);
}
void write_rows(const std::string& path, const ImageRows<float>& image, std::vector<std::string> channels,
                const WriteOptions& options) {
  const ImageFormat& format = format_to_write(path, {ImageValues::floats, image.channels});
  if (channels.empty()) channels = default_channels(image.channels);
  if (static_cast<int>(channels.size()) != image.channels)
    refuse_image(path, "", std::to_string(image.channels) + " channels", "a name for every channel");
  format.write_floats(path, image, channels, options);
}

void write_image(const std::string& path, const Image<std::uint8_t>& image, const WriteOptions& options) {
  write_rows(path, ImageRows(image), options);
}
void write_image(const std::string& path, const Image<std::uint16_t>& image, const WriteOptions& options) {
  write_rows(path, ImageRows(image), options);
}
void write_image(const std::string& path, const Image<std::uint32_t>& image, const WriteOptions& options) {
  write_rows(path, ImageRows(image), options);
}
void write_image(const std::string& path, const Image<float>& image, std::vector<std::string> channels,
                 const WriteOptions& options) {
  write_rows(path, ImageRows(image), std::move(channels), options);
}

} // namespace refraster
