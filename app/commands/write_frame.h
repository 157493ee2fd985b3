#pragma once
// The files that a frame becomes: what commands that render have in common.

#include <refraster/render.h>

#include "app/options/option.h"
#include "io/image/image_formats.h"

#include <string>
#include <vector>

namespace refraster {

/// How the image and its AOVs are written, as the options say.
struct FrameFiles {
  int bits = 0;           // of a channel: 8, 16, 32 (float); 0: as many as the format usually has
  int jpeg_quality = 95;
  std::string aov_format; // an extension, "npy"; empty: float_extension_beside
};

/// --bits.
Option bits_option(FrameFiles& files);
/// --quality.
Option quality_option(FrameFiles& files);
/// --aov-format.
Option aov_format_option(FrameFiles& files);

/// ".png or .jpg (8 bit), ...": for the help of --output.
std::string output_forms();

/// What the image holds: by the extension of its name, and by --bits.
ImageValues output_values(const FrameFiles& files, const std::string& output);

/// Throws UsageError where the format of `output` is not one to write an image in, or not with such values.
void check_output(const FrameFiles& files, const std::string& output, Transfer transfer);

/// Whether the image holds radiance, and not what of it can be shown.
bool writes_radiance(const FrameFiles& files, const std::string& output);

/// Asks for what write_frame() needs.
void ask_for_output(const FrameFiles& files, const std::string& output, RenderOptions& options);

/// Next to "ball.png" stands "ball.depth.pfm", next to "ball.exr" "ball.depth.exr".
std::string aov_path(const FrameFiles& files, const std::string& output, Aov aov);

/// Writes the image and the AOVs of a frame that was rendered with these options, and gives the paths. Throws OutputError,
/// OutOfMemory.
std::vector<std::string> write_frame(const FrameFiles& files, const std::string& output, const RenderOptions& options,
                                     const Frame& frame);

} // namespace refraster
