#include "io/scene/triangle_numbers.h"

#include <refraster/notes.h>
#include <refraster/render.h>

namespace refraster {

void check_triangle_numbers(const std::string& path, const Scene& scene, const std::string& option) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (const std::size_t triangles = scene.objects[i].mesh->triangles.size(); triangles > max_exact_triangle_id)
      throw InputError(InputFault{path, 0, 0, "/objects/" + std::to_string(i), std::to_string(triangles) + " triangles",
                                  "at most " + std::to_string(max_exact_triangle_id) + ", which the floats of " +
                                      option + " can number"});
}

} // namespace refraster
