#pragma once
// Scenes for the OpenGL tests, small enough to read.

#include <refraster/mesh.h>
#include <refraster/scene.h>

namespace refraster {

/// A ball, stretched along one axis, before a dark ground; a lamp at the upper left.
inline Scene ball(FragmentFunction function) {
  Scene scene;
  scene.camera.position = {0, 0, 5};
  scene.camera.target = {0, 0, 0};
  scene.background = {0.1, 0.2, 0.3};
  scene.point_lights = {{{-3, 4, 5}, {1, 1, 1}, 1, 0, 0}};
  scene.direction_lights = {{{0, -1, -0.2}, {0.2, 0.25, 0.3}}};
  Object object;
  object.name = "ball";
  object.mesh = std::make_shared<const Mesh>(sphere_mesh(32, 16));
  object.scale = {1.6, 1, 0.7};
  object.rotate_degrees = {10, 25, 0};
  object.material.fragment_function = std::move(function);
  scene.objects = {object};
  return scene;
}

} // namespace refraster
