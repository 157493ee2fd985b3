#pragma once
// Families of inputs: of each, a frame of any size.

#include <refraster/render.h>
#include <refraster/scene.h>

#include <span>
#include <string_view>

namespace refraster::cliffs {

/// A frame to be timed.
struct Work {
  Scene scene;
  RenderOptions options;
  /// How many layers of surfaces cover a pixel, in the mean over the image: known by construction, or an estimate from
  /// above. What is hidden has to be looked at too.
  double layers = 1;
};

/// What becomes four times as much from the first size to the second.
enum class Grows { triangles, pixels, objects, lights };

constexpr std::string_view words_of(Grows grows) {
  constexpr std::string_view words[] = {"triangles", "pixels", "objects", "lights"};
  return words[static_cast<int>(grows)];
}

struct Family {
  std::string_view name;
  Grows grows;
  double size; // at first: of what grows
  Work (*make)(double size);
  std::string_view reason = {}; // why it may cost more than ten times the ordinary, or grow faster; empty: it may not
};

/// Triangles: small, huge, thin, hidden, outside, before and behind the eye.
std::span<const Family> geometry_families();
/// Images of all shapes, samples, and what else is made of a frame.
std::span<const Family> pixel_families();
/// Materials, textures and lights.
std::span<const Family> shading_families();

} // namespace refraster::cliffs
