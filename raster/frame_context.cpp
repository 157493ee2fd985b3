#include "raster/frame_context.h"

#include <omp.h>

namespace refraster {

PixelRect rendered_region(const RenderOptions& options) {
  return options.crop.value_or(PixelRect{0, 0, options.width, options.height});
}

int thread_count(const RenderOptions& options) {
  return options.threads > 0 ? options.threads : omp_get_num_procs();
}

SceneUses uses_of(const Scene& scene) {
  SceneUses uses;
  for (const Object& object : scene.objects) {
    uses.two_sided |= object.two_sided == TwoSided::yes;
    uses.vertex_colours |= !object.mesh->colours.empty();
    uses.tangents |= !object.mesh->tangents.empty();
  }
  uses.placed_textures = any_material(scene, [](const Material& material) {
    return any_texture(material, [](const TextureMap& map) { return map.is_placed(); });
  });
  uses.cut_outs = any_material(scene, [](const Material& material) { return material.has_cut_outs(); });
  uses.shadows = has_shadows(scene);
  return uses;
}

} // namespace refraster
