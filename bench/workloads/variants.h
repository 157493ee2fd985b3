#pragma once
// A scene, changed in one thing: the difference of two frames' times is what that thing costs.

#include <refraster/scene.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace refraster::bench {

/// Nothing arrives: what is left is interpolation and the ambient term.
Scene without_lights(Scene scene);

/// The scene's last light once more, of its kind; a point light at the eye in a scene without any.
Scene with_one_more_light(Scene scene);

std::size_t lights(const Scene& scene);

Scene without_textures(Scene scene);

/// A small bilinear texture on each surface that would show one: that of a measured BRDF does not.
Scene with_textures(Scene scene);

/// Whether there is a texture that shows, and whether one could.
bool has_textures(const Scene& scene);
bool shows_textures(const Scene& scene);

/// What shades a part of a scene: a fragment function of shading/fragment_functions.h, and how it reads a measured
/// BRDF.
struct FragmentFunctionVariant {
  std::string_view name;
  std::optional<MerlLookup> lookup;
  bool operator==(const FragmentFunctionVariant&) const = default;
};

/// "blinn_phong", "merl trilinear".
std::string name_of(const FragmentFunctionVariant& function);

/// Each function of the scene once, in the order of its objects. Of measured BRDFs also `nearest` and `trilinear`,
/// whichever the scene uses: the two that most readers know.
std::vector<FragmentFunctionVariant> functions_of(const Scene& scene);

/// Only the objects that have this fragment function, measured BRDFs among them read with this lookup.
Scene only(Scene scene, const FragmentFunctionVariant& function);

} // namespace refraster::bench
