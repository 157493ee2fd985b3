#pragma once
// A square that is seen face on and fills the image.

#include <refraster/mesh.h>
#include <refraster/scene.h>

#include <memory>
#include <utility>

namespace refraster {

/// A square that fills a square image, facing the camera at a distance of 1, with texture coordinates from 0 at the
/// lower left to `repeats`; without lights. Its corners lie on the image's: the pixel in column x and row y of n sees
/// u = (x + 0.5) / n and v = (n - 0.5 - y) / n, times `repeats`.
inline Scene poster_scene(const Phong& function, float repeats = 1) {
  Scene scene;
  scene.camera.position = {0, 0, 1};
  scene.camera.target = {0, 0, 0};
  scene.camera.fov_y_degrees = 90;
  Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh.normals.assign(4, Float3(0, 0, 1));
  mesh.uvs = {{0, 0}, {repeats, 0}, {repeats, repeats}, {0, repeats}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  Object object;
  object.name = "poster";
  object.mesh = std::make_shared<const Mesh>(std::move(mesh));
  object.material.fragment_function = function;
  scene.objects = {object};
  return scene;
}

/// With another mesh for the first object.
void change_mesh(Scene& scene, auto&& change) {
  Mesh mesh = *scene.objects[0].mesh;
  change(mesh);
  scene.objects[0].mesh = std::make_shared<const Mesh>(std::move(mesh));
}

} // namespace refraster
