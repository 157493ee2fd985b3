#pragma once
// An image that shows nothing: found out, and explained in a sentence.

#include <refraster/render.h>

#include <cstdint>
#include <optional>
#include <string>

namespace refraster {

/// A value of an 8-bit image counts as nearly black up to here, and radiance in a float image, which viewers show by
/// the sRGB curve, up to nearly_black_radiance: a hundredth of white, which the curve takes to 25.5 of 255. In the
/// viewing conditions that IEC 61966-2-1 defines sRGB for, a display's surface reflects as much of the room's light:
/// "viewing flare 1.0 %". What is darker than that is not told from black.
inline constexpr std::uint8_t nearly_black_level = 25;
inline constexpr double nearly_black_radiance = 0.01;

/// The images of a frame; an empty one is not looked at. At least one is there.
struct ShownImages {
  const Image<std::uint8_t>& rgb8;
  const Image<float>& radiance;
};

/// Why the image shows no surface, or surfaces that are all nearly black: one sentence for a note, without a full stop;
/// empty if it shows anything brighter. `options` are those that the images were made with; nullopt for
/// `shaded_pixels`, how many pixels see a surface, where it is not known (OpenGL's image).
///
/// An image that shows something is read up to the first pixel that says so, no further. Any other is explained by a
/// frame of its own, of at most 2^20 pixels, one sample each. Where memory does not suffice for that, or it is
/// cancelled, there is no explanation.
std::string explain_dark_image(const Scene& scene, const RenderOptions& options, const ShownImages& images,
                               std::optional<std::uint64_t> shaded_pixels);

/// The same for an image that is known to show no surface.
std::string explain_no_surface(const Scene& scene, const RenderOptions& options);

} // namespace refraster
