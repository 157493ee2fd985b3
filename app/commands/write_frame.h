#pragma once
// The files that a frame becomes: what commands that render have in common.

#include <refraster/render.h>

#include "app/diagnostics.h"
#include "app/options/option.h"
#include "io/image/image_formats.h"

#include <string>
#include <vector>

namespace refraster {

/// Whether AOVs stand in files beside the image's, or in its file.
enum class AovPlace { beside, layers };

/// How the image and its AOVs are written, as the options say.
struct FrameFiles {
  int bits = 0; // of a channel: 8, 16, 32 (float); 0: as many as the format usually has
  int jpeg_quality = 95;
  std::vector<Aov> aovs;
  AovFilter aov_filter = AovFilter::nearest;
  AovPlace aov_place = AovPlace::beside;
  std::string aov_format; // an extension, "npy"; empty: float_extension_beside
  Background background = Background::blended;
};

/// --bits.
Option bits_option(FrameFiles& files);
/// --quality.
Option quality_option(FrameFiles& files);
/// --transparent.
Option transparent_option(FrameFiles& files);
/// --aov, --aov-filter, --aov-format, --layers.
std::vector<Option> aov_options(FrameFiles& files);

/// ".png or .jpg (whole numbers), ...": for the help of --output.
std::string output_forms();

/// What the image holds: by the extension of its name, and by --bits.
ImageValues output_values(const FrameFiles& files, const std::string& output);

/// Whether the image holds radiance, and not what of it can be shown.
bool writes_radiance(const FrameFiles& files, const std::string& output);

/// Throws UsageError where the format of `output` is not one to write an image in, or not as the options say. What is
/// left out without a fault is noted: a JPEG has no alpha.
void check_output(FrameFiles& files, const std::string& output, Transfer transfer, const Diagnostics& diagnostics);

/// Asks for what write_frame() needs.
void ask_for_output(const FrameFiles& files, const std::string& output, RenderOptions& options);

/// The extensions of the formats that AOVs can be asked to have.
std::vector<std::string> aov_formats();

/// Those of the options, or all where the file of the image is to hold them and none is named.
std::vector<Aov> written_aovs(const FrameFiles& files);

/// The files of the AOVs: next to "ball.png" stands "ball.depth.pfm", next to "ball.exr" "ball.depth.exr".
std::vector<std::string> aov_paths(const FrameFiles& files, const std::string& output);

/// Writes the image and the AOVs of a frame that was rendered with options that ask_for_output() has completed, and
/// gives the paths. Throws OutputError, std::bad_alloc.
std::vector<std::string> write_frame(const FrameFiles& files, const std::string& output, const RenderOptions& options,
                                     const Frame& frame);

} // namespace refraster
