#pragma once
// Things that stand on a floor and before each other, under lights with shadows and without.

#include <refraster/mesh.h>
#include <refraster/scene.h>

#include <memory>
#include <utility>

namespace refraster {

/// All lights with such shadows, or with none.
inline Scene with_shadows(Scene scene, const CastShadow& shadow) {
  for_each_light_list(scene, [&](auto& lights) {
    for (auto& light : lights) light.shadow = shadow;
  });
  return scene;
}

/// A floor that reaches behind the eye, a knot and a ball on it, and a card that is culled and out of view, of which
/// only the shadow is seen. The last light of each list has none.
inline Scene shadow_scene() {
  Scene scene;
  scene.camera = {{0.4, 1.8, 4.2}, {0, 0, 0}, {0, 1, 0}, 45, 0.1, 60};
  scene.background = {0.2, 0.25, 0.3};
  scene.point_lights = {{{-2, 3, 2.5}, {0.9, 0.8, 0.7}, 1, 0, 0, Shadow::exact},
                        {{2, 2, 1.5}, {0.9, 1, 1.2}, 0.5, 0.1, 0.1, Shadow::exact},
                        {{0, 4, 0}, {0.1, 0.1, 0.1}, 1, 0, 0}};
  scene.direction_lights = {{{-0.4, -1, -0.2}, {0.4, 0.4, 0.3}, Shadow::exact}, {{0, 0, -1}, {0.1, 0.1, 0.1}}};
  const auto add = [&](Mesh mesh, const Double3& position, const Double3& rotate, const Double3& scale,
                       const Double3& colour) -> Object& {
    Phong function;
    function.ka = 0.05 * colour, function.kd = colour, function.ks = Double3(0.3), function.glossiness = 15;
    Object& object = scene.objects.emplace_back();
    object.mesh = std::make_shared<const Mesh>(std::move(mesh));
    object.position = position, object.rotate_degrees = rotate, object.scale = scale;
    object.material.fragment_function = function;
    return object;
  };
  add(plane_mesh(2), {0, -0.8, 0}, {0, 20, 0}, {9, 1, 9}, {0.8, 0.8, 0.8});
  add(knot_mesh(48, 8, 0.24), {0.3, 0.1, 0}, {70, 0, 20}, Double3(0.7), {0.5, 0.6, 0.8});
  add(sphere_mesh(16, 8), {-1, -0.3, 0.5}, {10, 20, 30}, Double3(0.5), {0.8, 0.5, 0.3});
  add(plane_mesh(1), {-0.8, 3.2, 1.5}, {180, 0, 0}, {0.5, 1, 0.5}, {1, 1, 1}).cull = Cull::back;
  return scene;
}

} // namespace refraster
