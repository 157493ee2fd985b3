#include "scene/exposure.h"

#include "math/elementary.h"

#include <variant>

namespace refraster {

void expose(Scene& scene, double stops) {
  const double factor = exp2(stops); // exact for whole stops, and the same on every machine
  if (factor == 1) return;
  scene.background *= factor;
  for_each_light_list(scene, [&](auto& lights) {
    for (auto& light : lights) light.radiance *= factor;
  });
  for_each_material(scene, [&](Material& material) {
    material.emissive *= factor;
    std::visit(
        [&](auto& function) {
          if constexpr (requires { function.ka; }) function.ka *= factor;
        },
        material.fragment_function);
  });
}

} // namespace refraster
