#pragma once
// A scene in which a texture is shown on some triangles of a mesh only.

#include <refraster/mesh.h>
#include <refraster/scene.h>

namespace refraster {

/// A knot of which the first half has texture coordinates.
inline Scene half_textured(TextureFilter filter) {
  Scene scene;
  scene.camera.position = {0.5, 3, 4};
  scene.camera.target = {0, 0, 0};
  scene.background = {0.1, 0.2, 0.3};
  scene.point_lights = {{{-3, 4, 5}, {1, 1, 1}, 1, 0, 0}};
  Mesh mesh = knot_mesh(96, 12, 0.3);
  mesh.uvs.resize(mesh.positions.size() / 2);
  auto texture = std::make_shared<Texture>();
  TextureLevel image{8, 4, {}};
  for (int i = 0; i < 3 * 8 * 4; ++i) image.rgb.push_back(static_cast<float>(i * 89 % 200));
  texture->levels.push_back(std::move(image));
  build_mip_levels(*texture);
  BlinnPhong function;
  function.ka = Double3(0.2), function.kd = Double3(0.8), function.ks = Double3(0.3), function.glossiness = 20;
  Object object;
  object.name = "knot";
  object.mesh = std::make_shared<const Mesh>(std::move(mesh));
  object.material.fragment_function = function;
  object.material.diffuse_map.texture = std::move(texture), object.material.diffuse_map.filter = filter;
  scene.objects = {object};
  return scene;
}

} // namespace refraster
