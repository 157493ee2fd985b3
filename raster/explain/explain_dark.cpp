#include "raster/explain/explain_dark.h"

#include "math/elementary.h"
#include "raster/explain/why_dark.h"
#include "raster/explain/why_unseen.h"
#include "raster/frame_context.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <new>
#include <vector>

namespace refraster {
namespace {

/// The radiance that a value of an image stands for: between two bounds, because it is rounded.
struct Bounds {
  double least, most;
};

/// The inverse of the sRGB curve, IEC 61966-2-1, for y in [0, 1].
double srgb_decoded(double y) {
  return y <= 0.04045 ? y / 12.92 : pow((y + 0.055) / 1.055, 2.4);
}

/// A level stands for what is within half a level of it; the greatest one for everything above, too.
std::array<Bounds, 256> bounds_of_levels(Transfer transfer) {
  std::array<Bounds, 256> bounds;
  const auto radiance = [&](double level) {
    const double y = std::clamp(level / 255, 0.0, 1.0);
    return transfer == Transfer::srgb ? srgb_decoded(y) : y;
  };
  for (std::size_t level = 0; level < bounds.size(); ++level)
    bounds[level] = {radiance(static_cast<double>(level) - 0.5), radiance(static_cast<double>(level) + 0.5)};
  bounds.back().most = std::numeric_limits<double>::infinity();
  return bounds;
}

/// A mean of so many samples has as many roundings of a float at most as there are samples, one for the background and
/// one where it is stored, each of half an ulp. The largest float stands for everything above, too.
Bounds bounds_of_radiance(float value, int samples) {
  const double radiance = static_cast<double>(value), off = std::abs(radiance) * (samples + 2) * 0x1p-24;
  const bool is_largest = value == std::numeric_limits<float>::max();
  return {radiance - off, is_largest ? std::numeric_limits<double>::infinity() : radiance + off};
}

/// Whether a pixel may be a mean of the background and of samples from black to `dark`: for a fraction of k / samples
/// of such samples it is.
bool may_be_dark(const std::array<Bounds, 3>& pixel, const Double3& background, double dark, int samples) {
  for (int k = 0; k <= samples; ++k) {
    const double fraction = static_cast<double>(k) / samples;
    bool is_mean = true;
    for (int c = 0; c < 3; ++c) {
      const Bounds& value = pixel[static_cast<std::size_t>(c)];
      const double least = (1 - fraction) * background[c], most = least + fraction * dark;
      is_mean &= value.least <= most && value.most >= least;
    }
    if (is_mean) return true;
  }
  return false;
}

/// Whether every pixel may be dark. Most images are found not to be by one of their first pixels that shows a surface.
template <class Value, class BoundsOf>
bool all_may_be_dark(const Image<Value>& image, const Double3& background, double dark, int samples,
                     const BoundsOf& bounds_of) {
  for (std::size_t i = 0; i < image.values.size(); i += 3) {
    const Value* const v = &image.values[i];
    if (!may_be_dark({bounds_of(v[0]), bounds_of(v[1]), bounds_of(v[2])}, background, dark, samples)) return false;
  }
  return true;
}

/// The radiance up to which a surface is nearly black in the image that these options make.
double dark_radiance(const RenderOptions& options) {
  return options.want_rgb8 ? bounds_of_levels(options.transfer)[nearly_black_level].most : nearly_black_radiance;
}

bool all_may_be_dark(const Scene& scene, const RenderOptions& options, const ShownImages& images) {
  const double dark = dark_radiance(options);
  const auto bounds = bounds_of_levels(options.transfer);
  if (!images.rgb8.empty() && !all_may_be_dark(images.rgb8, scene.background, dark, options.samples,
                                               [&](std::uint8_t level) { return bounds[level]; }))
    return false;
  return images.radiance.empty() ||
         all_may_be_dark(images.radiance, scene.background, dark, options.samples,
                         [&](float value) { return bounds_of_radiance(value, options.samples); });
}

/// The same view in at most 2^20 pixels.
RenderOptions options_to_look_with(const RenderOptions& options) {
  RenderOptions smaller;
  smaller.threads = options.threads;
  smaller.tile_size = options.tile_size;
  smaller.want_rgb8 = options.want_rgb8;
  smaller.want_radiance = !options.want_rgb8;
  smaller.transfer = options.transfer;
  smaller.aovs = {Aov::object, Aov::position, Aov::normal};
  smaller.cancel = options.cancel;
  smaller.memory = options.memory;
  constexpr double max_pixels = 0x1p20;
  const PixelRect region = rendered_region(options);
  const int divisor = static_cast<int>(
      std::ceil(std::sqrt(std::max(1.0, static_cast<double>(region.width) * region.height / max_pixels))));
  smaller.width = std::max(1, options.width / divisor);
  smaller.height = std::max(1, options.height / divisor);
  if (!options.crop) return smaller;
  const int x = std::min(region.x / divisor, smaller.width - 1), y = std::min(region.y / divisor, smaller.height - 1);
  smaller.crop = PixelRect{x, y, std::clamp(region.width / divisor, 1, smaller.width - x),
                           std::clamp(region.height / divisor, 1, smaller.height - y)};
  return smaller;
}

/// Of the pixels that show a surface, the greatest value.
template <class Value>
Value brightest_surface(const Image<Value>& image, const Image<float>& objects) {
  Value most{};
  for (std::size_t i = 0; i < image.values.size(); ++i)
    if (objects.values[i / 3] != 0) most = std::max(most, image.values[i]);
  return most;
}

/// "the image is nearly black, no value above 12 of 255"; empty if a surface is brighter.
std::string nearly_black(const Frame& frame, const Scene& scene, double dark) {
  std::string value;
  if (!frame.rgb8.empty()) {
    const std::uint8_t most = brightest_surface(frame.rgb8, frame.aovs[0]);
    if (most > nearly_black_level) return {};
    value = std::to_string(most) + " of 255";
  } else {
    const auto most = static_cast<double>(brightest_surface(frame.radiance, frame.aovs[0]));
    if (most > nearly_black_radiance) return {};
    char text[40];
    std::snprintf(text, sizeof text, "%.2g", most);
    value = text;
  }
  const Double3& b = scene.background;
  const bool dark_background = std::max({b.x, b.y, b.z}) <= dark;
  return (dark_background ? "the image is nearly black, no value above "
                          : "all surfaces are nearly black, none above ") +
         value;
}

Scene without_shadows(Scene scene) {
  for_each_light_list(scene, [](auto& lights) {
    for (auto& light : lights) light.shadow = Shadow::none;
  });
  return scene;
}

std::string explained(const Scene& scene, const RenderOptions& options, std::optional<std::uint64_t> shaded_pixels) {
  const RenderOptions looking = options_to_look_with(options);
  const Frame frame = render(scene, looking);
  if (frame.cancelled) return {};
  if (frame.counts.shaded == 0) {
    // In fewer pixels, small surfaces may not be seen.
    const bool knows = looking.width == options.width && looking.height == options.height;
    return !shaded_pixels && knows ? explain_no_surface(scene, options) : "";
  }
  const double dark = dark_radiance(options);
  const std::string what = nearly_black(frame, scene, dark);
  if (what.empty()) return {};
  if (has_shadows(scene)) {
    const Scene shadowless = without_shadows(scene);
    const Frame lit = render(shadowless, looking);
    if (lit.cancelled) return {};
    if (nearly_black(lit, shadowless, dark).empty()) return what + ": what is seen lies in shadow";
  }
  return what + ": " + why_dark(scene, frame, dark);
}

} // namespace

std::string explain_no_surface(const Scene& scene, const RenderOptions& options) {
  try {
    return std::string(options.crop ? "the crop" : "the image") +
           " shows background only: " + why_unseen(scene, options.width, options.height, rendered_region(options));
  } catch (const std::bad_alloc&) {
    return {};
  }
}

std::string explain_dark_image(const Scene& scene, const RenderOptions& options, const ShownImages& images,
                               std::optional<std::uint64_t> shaded_pixels) {
  if (shaded_pixels == std::uint64_t{0}) return explain_no_surface(scene, options);
  if (!all_may_be_dark(scene, options, images)) return {};
  try {
    return explained(scene, options, shaded_pixels);
  } catch (const std::bad_alloc&) {
    return {}; // the image is there: that it cannot be explained is no reason to fail
  }
}

} // namespace refraster
