#include "raster/frame_context.h"

#include <algorithm>
#include <omp.h>

namespace refraster {

PixelRect rendered_region(const RenderOptions& options) {
  return options.crop.value_or(PixelRect{0, 0, options.width, options.height});
}

int thread_count(const RenderOptions& options) {
  return options.threads > 0 ? options.threads : omp_get_num_procs();
}

bool has_two_sided(const Scene& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(),
                     [](const Object& object) { return object.two_sided == TwoSided::yes; });
}

bool any_vertex_colours(const Scene& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(),
                     [](const Object& object) { return !object.mesh->colours.empty(); });
}

} // namespace refraster
