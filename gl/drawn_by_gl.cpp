#include "gl/drawn_by_gl.h"

#include <refraster/notes.h>

namespace refraster {

void check_drawn_by_gl(const std::string& path, const Scene& scene) {
  for_each_light_list(scene, [&]<class Light>(const std::vector<Light>& lights) {
    for (std::size_t i = 0; i < lights.size(); ++i)
      if (lights[i].shadow == Shadow::exact)
        throw InputError(
            InputFault{path, 0, 0, "/scene/" + std::string(Light::names.key) + "/" + std::to_string(i) + "/shadow",
                       '"' + std::string(name_of(lights[i].shadow.kind)) + "\", which OpenGL does not cast",
                       "\"none\" or a map for OpenGL, as with --shadow map; refraster render and explain cast it"});
  });
}

} // namespace refraster
