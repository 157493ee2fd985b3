#include "app/commands/write_frame.h"

#include <refraster/files.h>

#include "app/output.h"
#include "app/usage_error.h"
#include "io/file/text.h"
#include "raster/frame_context.h"
#include "raster/levels.h"

#include <algorithm>
#include <optional>

namespace refraster {
namespace {

struct Depth {
  int bits;
  ImageValues values;
};
constexpr Depth depths[] = {{8, ImageValues::uint8}, {16, ImageValues::uint16}, {32, ImageValues::floats}};

/// Whole numbers, as which an AOV is kept beside floats.
bool is_number(Aov aov) {
  return aov == Aov::triangle || aov == Aov::object;
}

/// The formats that AOVs can be asked to have.
std::vector<std::string> aov_formats() {
  std::vector<std::string> extensions;
  for (const ImageFormat& format : image_formats)
    if (can_write(format, float_grey_image) && can_write(format, float_rgb_image))
      extensions.emplace_back(format.extensions[0]);
  return extensions;
}

void write_aov(const std::string& path, Aov aov, const Image<float>& image) {
  if (!is_number(aov) || !format_to_write(path, {{ImageValues::uint32, 1}})) return write_values(path, image);
  Image<std::uint32_t> numbers(image.width, image.height, image.channels);
  std::transform(image.values.begin(), image.values.end(), numbers.values.begin(),
                 [](float value) { return static_cast<std::uint32_t>(value); });
  write_image(path, numbers);
}

} // namespace

Option bits_option(FrameFiles& files) {
  return value_option("--bits", "8|16|32",
                      "bits a channel: 8 or 16 of whole numbers, 32 of floats; by default floats where the format has "
                      "them, else 8",
                      [&files](const std::string& text) -> std::optional<ValueFault> {
                        const std::optional<int> bits = number_from<int>(text);
                        if (bits != 8 && bits != 16 && bits != 32) return ValueFault{"8, 16 or 32"};
                        files.bits = *bits;
                        return std::nullopt;
                      });
}

Option quality_option(FrameFiles& files) {
  return number_option("--quality", files.jpeg_quality, Range{1, 100}, "of a .jpg: more is better, and larger");
}

Option aov_format_option(FrameFiles& files) {
  return word_option(
      "--aov-format", aov_formats(), [&files](std::size_t i) { files.aov_format = aov_formats()[i]; },
      "format of the images of --aov; by default that of the image where it holds floats, else pfm");
}

std::string output_forms() {
  return writable_extensions({rgb8_image}) + " (whole numbers), " + writable_extensions({float_rgb_image}) +
         " (float, unclamped)";
}

ImageValues output_values(const FrameFiles& files, const std::string& output) {
  for (const Depth& depth : depths)
    if (depth.bits == files.bits) return depth.values;
  return format_to_write(output, {float_rgb_image}) ? ImageValues::floats : ImageValues::uint8;
}

bool writes_radiance(const FrameFiles& files, const std::string& output) {
  return output_values(files, output) == ImageValues::floats;
}

void check_output(const FrameFiles& files, const std::string& output, Transfer transfer) {
  check_extension("--output", output, {rgb8_image, float_rgb_image});
  const ImageContent content{output_values(files, output), 3};
  if (!format_to_write(output, {content}))
    throw UsageError("--bits", std::to_string(files.bits) + " of \"" + output + "\"",
                     "a name ending in " + writable_extensions({content}));
  if (transfer == Transfer::srgb && writes_radiance(files, output))
    throw UsageError("--srgb", "is for " + writable_extensions({rgb8_image}) + "; float images hold linear values");
}

void ask_for_output(const FrameFiles& files, const std::string& output, RenderOptions& options) {
  const ImageValues values = output_values(files, output);
  options.want_rgb8 = values != ImageValues::floats; // of 16 bits, to see whether it shows anything
  options.want_radiance_double = values == ImageValues::uint16; // which floats would round before
  options.want_radiance = values == ImageValues::floats;
}

std::string aov_path(const FrameFiles& files, const std::string& output, Aov aov) {
  const std::size_t dot = output.rfind('.');
  return output.substr(0, dot) + "." + std::string(aov_names[static_cast<std::size_t>(aov)]) +
         (files.aov_format.empty() ? float_extension_beside(output) : "." + files.aov_format);
}

std::vector<std::string> write_frame(const FrameFiles& files, const std::string& output, const RenderOptions& options,
                                     const Frame& frame) {
  const WriteOptions writing{.curve = options.transfer == Transfer::srgb ? StatedCurve::srgb : StatedCurve::none,
                             .jpeg_quality = files.jpeg_quality,
                             .threads = options.threads};
  switch (output_values(files, output)) {
  case ImageValues::floats:
    write_values(output, frame.radiance);
    break;
  case ImageValues::uint16: {
    options.memory.need(3 * sizeof(std::uint16_t) * frame.radiance_double.values.size(), output); // and packed
    write_image(output, levels16(frame.radiance_double, options.transfer, thread_count(options)), writing);
    break;
  }
  default:
    options.memory.need(2 * frame.rgb8.values.size(), output); // PNG is made in memory: filtered, and packed
    write_image(output, frame.rgb8, writing);
  }
  std::vector<std::string> paths = {output};
  for (std::size_t i = 0; i < options.aovs.size(); ++i) {
    paths.push_back(aov_path(files, output, options.aovs[i]));
    write_aov(paths.back(), options.aovs[i], frame.aovs[i]);
  }
  return paths;
}

} // namespace refraster
