#pragma once
// The size of an image, its samples and its curve: options over what the scene's "picture" says.

#include "app/arguments.h"
#include "app/options/option.h"
#include "raster/vertex/scene_view.h"

#include <optional>
#include <string>

namespace refraster {

/// What was asked for; nothing where the scene says it.
struct PictureArguments {
  std::optional<Size> size;
  std::optional<int> samples;
  std::optional<Transfer> transfer;

  /// The image to make of a scene that says this. Throws UsageError for more samples in all than there may be.
  Picture over(const Picture& of_scene) const;
};

/// --size WxH.
Option size_option(PictureArguments& picture, const std::string& meaning = "pixels of the image");
/// --samples N.
Option samples_option(PictureArguments& picture, const std::string& meaning);
/// --srgb, --linear.
Option srgb_option(PictureArguments& picture, const std::string& meaning);
Option linear_option(PictureArguments& picture);

} // namespace refraster
