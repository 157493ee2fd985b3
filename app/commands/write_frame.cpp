#include "app/commands/write_frame.h"

#include <refraster/files.h>

#include "app/commands/frame_rows.h"
#include "app/output.h"
#include "app/usage_error.h"
#include "io/file/text.h"

#include <algorithm>
#include <optional>

namespace refraster {
namespace {

bool is_transparent(const FrameFiles& files) {
  return files.background == Background::transparent;
}

std::vector<Aov> all_aovs() {
  std::vector<Aov> all;
  for (std::size_t i = 0; i < std::size(aov_kinds); ++i) all.push_back(static_cast<Aov>(i));
  return all;
}

} // namespace

Option bits_option(FrameFiles& files) {
  return value_option("--bits", "8|16|32",
                      "bits a channel: 8 or 16 of whole numbers, 32 of floats; by default floats where the format has "
                      "them, else 8",
                      [&files](const std::string& text) -> std::optional<ValueFault> {
                        std::vector<std::string> choices;
                        for (const ImageDepth& depth : image_depths) {
                          if (depth.asked_bits == 0) continue;
                          choices.push_back(std::to_string(depth.asked_bits));
                          if (number_from<int>(text) == depth.asked_bits) files.bits = depth.asked_bits;
                          else continue;
                          return std::nullopt;
                        }
                        return ValueFault{alternatives(choices)};
                      });
}

Option quality_option(FrameFiles& files) {
  return number_option("--quality", files.jpeg_quality, Range{1, 100}, "of a .jpg: more is better, and larger");
}

Option transparent_option(FrameFiles& files) {
  return flag(
      "--transparent", [&files] { files.background = Background::transparent; },
      "leave the background out: an alpha channel says how much of a pixel's samples see a surface; colours are "
      "straight, "
      "of floats multiplied by it");
}

std::vector<Option> aov_options(FrameFiles& files) {
  std::vector<std::string> names;
  std::string meaning;
  for (const AovKind& kind : aov_kinds) {
    names.emplace_back(kind.name);
    meaning += "; " + std::string(kind.name) + ": " + std::string(kind.meaning);
  }
  const auto set_aovs = [&files](const std::vector<std::size_t>& indices) {
    for (const std::size_t i : indices) files.aovs.push_back(static_cast<Aov>(i));
  };
  return {
      word_list_option("--aov", "NAME,…", names, set_aovs,
                       "more images to write (arbitrary output variables), as NAME.depth.pfm next to NAME.png, .exr "
                       "next to .exr" +
                           meaning),
      enum_option("--aov-filter", files.aov_filter,
                  "of several samples a pixel: the first surface, or the mean of all; numbers are always the first's"),
      word_option(
          "--aov-format", aov_formats(), [&files](std::size_t i) { files.aov_format = aov_formats()[i]; },
          "format of the images of --aov; by default that of the image where it holds floats, else pfm"),
      flag(
          "--layers", [&files] { files.aov_place = AovPlace::layers; },
          "of an .exr: AOVs as layers of its file, N.X, P.X, Z and so on; all of them unless --aov names some")};
}

std::string output_forms() {
  return writable_extensions({rgb8_image}) + " (whole numbers), " + writable_extensions({float_rgb_image}) +
         " (float, unclamped)";
}

ImageValues output_values(const FrameFiles& files, const std::string& output) {
  for (const ImageDepth& depth : image_depths)
    if (files.bits != 0 && depth.asked_bits == files.bits) return depth.values;
  return format_to_write(output, {float_rgb_image}) ? ImageValues::floats : ImageValues::uint8;
}

bool writes_radiance(const FrameFiles& files, const std::string& output) {
  return output_values(files, output) == ImageValues::floats;
}

void check_output(FrameFiles& files, const std::string& output, Transfer transfer, const Diagnostics& diagnostics) {
  check_extension("--output", output, {rgb8_image, float_rgb_image});
  const ImageValues values = output_values(files, output);
  if (!format_to_write(output, {{values, 3}}))
    throw UsageError("--bits", std::to_string(files.bits) + " of \"" + output + "\"",
                     "a name ending in " + writable_extensions({{values, 3}}));
  if (transfer == Transfer::srgb && writes_radiance(files, output))
    throw UsageError("--srgb", "is for " + writable_extensions({rgb8_image}) + "; float images hold linear values");
  if (files.aov_place == AovPlace::layers && format_of_name(output)->name != "OpenEXR")
    throw UsageError("--layers", "\"" + output + "\"", "a name ending in .exr");
  if (is_transparent(files) && !format_to_write(output, {{values, 4}})) {
    if (values != ImageValues::uint8)
      throw UsageError("--transparent", "\"" + output + "\"", "a name ending in " + writable_extensions({{values, 4}}));
    print_note(output + ": a JPEG has no alpha: the image is drawn over the background", diagnostics);
    files.background = Background::blended;
  }
}

void ask_for_output(const FrameFiles& files, const std::string& output, RenderOptions& options) {
  const ImageValues values = output_values(files, output);
  options.want_rgb8 = values != ImageValues::floats;            // of 16 bits, to see whether it shows anything
  options.want_radiance_double = values == ImageValues::uint16; // which floats would round before
  options.want_radiance = values == ImageValues::floats;
  options.background = files.background;
  options.aov_filter = files.aov_filter;
  options.aovs = written_aovs(files);
  if (is_transparent(files) && std::find(options.aovs.begin(), options.aovs.end(), Aov::alpha) == options.aovs.end())
    options.aovs.push_back(Aov::alpha);
}

std::vector<std::string> aov_formats() {
  std::vector<std::string> extensions;
  for (const ImageFormat& format : image_formats)
    if (can_write(format, float_grey_image) && can_write(format, float_rgb_image))
      extensions.emplace_back(format.extensions[0]);
  return extensions;
}

std::vector<Aov> written_aovs(const FrameFiles& files) {
  return files.aov_place == AovPlace::layers && files.aovs.empty() ? all_aovs() : files.aovs;
}

std::vector<std::string> aov_paths(const FrameFiles& files, const std::string& output) {
  std::vector<std::string> paths;
  if (files.aov_place == AovPlace::layers) return paths;
  const std::string extension = files.aov_format.empty() ? float_extension_beside(output) : "." + files.aov_format;
  for (const Aov aov : files.aovs)
    paths.push_back(output.substr(0, output.rfind('.')) + "." + std::string(kind_of(aov).name) + extension);
  return paths;
}

std::vector<std::string> write_frame(const FrameFiles& files, const std::string& output, const RenderOptions& options,
                                     const Frame& frame) {
  return write_frame_rows(files, output, options.transfer, options.threads, rows_of(files, output, options, frame));
}

} // namespace refraster
