// Faults of what the "mapped" one of the fault scenes has: maps but for the colour's, sides, colours of vertices.

#include "tests/support/gl/seeded_scene_faults.h"

#include "shading/srgb_curve.h"

#include <algorithm>

namespace refraster {
namespace {

constexpr FaultyStage fragment = FaultyStage::fragment;

/// Textures of colour with all values as `map` makes them of values that mean 1 at 1; linear ones, or decoded ones.
template <class Map>
Scene with_textures(Scene scene, bool decoded, const Map& map) {
  for (Object& object : scene.objects) {
    TextureMap& slot = object.material.diffuse_map;
    if (!slot.texture || (slot.texture->full_scale == 1) != decoded) continue;
    Texture texture{slot.texture->full_scale, {slot.texture->levels[0]}};
    for (float& value : texture.levels[0].rgb)
      value = static_cast<float>(texture.full_scale * map(static_cast<double>(value) / texture.full_scale));
    if (slot.texture->levels.size() > 1) build_mip_levels(texture);
    slot.texture = std::make_shared<const Texture>(std::move(texture));
  }
  return scene;
}

Scene srgb_not_decoded(Scene scene, const FaultImageSize&) {
  return with_textures(std::move(scene), true, srgb_encoded<double>);
}
Scene linear_decoded(Scene scene, const FaultImageSize&) {
  return with_textures(std::move(scene), false, srgb_decoded);
}

Scene without_vertex_colours(Scene scene, const FaultImageSize&) {
  for (Object& object : scene.objects) {
    Mesh mesh = *object.mesh;
    mesh.colours.clear();
    object.mesh = std::make_shared<const Mesh>(std::move(mesh));
  }
  return scene;
}

/// Bricks stand out twice as far.
Scene normals_too_strong(Scene scene, const FaultImageSize&) {
  for (Object& object : scene.objects) object.material.normal_scale *= 2;
  return scene;
}

} // namespace

std::vector<SeededFault> seeded_map_faults() {
  return {
      {"nothing cut out by the opacity map", {"opacity_missing"}, {{fragment, "< opacityThreshold", "< 0.0"}}},
      {"an opacity map taken for transparency",
       {"opacity_inverted"},
       {{fragment, "return texture(opacityTex, OPACITY_MAP_AT).r <",
         "return 1.0 - texture(opacityTex, OPACITY_MAP_AT).r <"}}},
      {"a normal map of the other convention, green down",
       {"bitangents_reversed"},
       {{fragment, "vec3 b = tangent.w *", "vec3 b = -tangent.w *"}}},
      {"the tangents' handedness left out", {"bitangents_reversed"}, {{fragment, "vec3 b = tangent.w *", "vec3 b = "}}},
      {"a normal map's red from the other end",
       {"normal_map_red_reversed"},
       {{fragment, "m.x * tangent.xyz", "m.x * -tangent.xyz"}}},
      {"the tangents reversed",
       {"tangents_reversed"},
       {{fragment, "vec4 tangent = fs_in(Tangent);", "vec4 tangent = fs_in(Tangent); tangent.xyz = -tangent.xyz;"}}},
      {"the normal map not used", {"normal_maps_missing"}, {{fragment, "n = mapped_normal(n, tangent);", ""}}},
      {"a two-sided object lit from one side",
       {"two_sided_missing"},
       {{fragment, "gl_FrontFacing ? frontSign : -frontSign", "1.0"}}},
      {"the specular map not used",
       {"specular_map_missing"},
       {{fragment, "specular_colour *= texture(specularTex, SPECULAR_MAP_AT).rgb;", ""}}},
      {"no light of the surface's own",
       {"emission_missing"},
       {{fragment, "vec3 own = emissive;", "vec3 own = vec3(0.0);"}}},
      {"the vertices' colours not used", {"vertex_colors_missing"}, {}, without_vertex_colours},
      {"an sRGB texture not decoded", {"srgb_texture_not_decoded"}, {}, srgb_not_decoded},
      {"a linear texture decoded", {"linear_texture_decoded"}, {}, linear_decoded},
      {"a normal map twice as strong", {}, {}, normals_too_strong},
  };
}

} // namespace refraster
