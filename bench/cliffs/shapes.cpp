#include "bench/cliffs/shapes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace refraster::cliffs {

Double3 Numbers::between(const Double3& lo, const Double3& hi) {
  const double x = between(lo.x, hi.x), y = between(lo.y, hi.y);
  return {x, y, between(lo.z, hi.z)};
}

Scene empty_scene(double distance) {
  Scene scene;
  scene.camera = {{0, 0, distance}, {0, 0, 0}, {0, 1, 0}, 90, 0.01, 100};
  scene.background = {0.1, 0.1, 0.15};
  scene.point_lights = {{{-2, 3, 4}, Double3(1), 1, 0, 0}};
  return scene;
}

BlinnPhong plastic() {
  BlinnPhong function;
  function.ka = Double3(0.05), function.kd = {0.6, 0.5, 0.4}, function.ks = Double3(0.3), function.glossiness = 20;
  return function;
}

Object object_of(std::shared_ptr<const Mesh> mesh) {
  Object object;
  object.mesh = std::move(mesh);
  object.material.fragment_function = plastic();
  return object;
}
Object object_of(Mesh mesh) {
  return object_of(std::make_shared<const Mesh>(std::move(mesh)));
}

Mesh wall(double triangles) {
  Mesh mesh = plane_mesh(std::max(1, static_cast<int>(std::lround(std::sqrt(triangles / 2)))));
  for (Float3& p : mesh.positions) p = {p.x, -p.z, 0};
  mesh.normals.assign(mesh.positions.size(), Float3(0, 0, 1));
  return mesh;
}

Mesh scattered(std::uint32_t triangles, double pixels, int side) {
  Numbers numbers;
  const double size = pixels * 2 / side;
  Double3 middle;
  return soup(triangles, [&](std::uint32_t, int k) {
    if (k == 0) middle = numbers.between({-1, -1, -0.5}, {1, 1, 0});
    // Farther off, more is seen and it looks smaller.
    const double scale = 1 - middle.z, angle = 2.1 * k + middle.x;
    return Double3(scale * (middle.x + size / 2 * std::cos(angle)), scale * (middle.y + size / 2 * std::sin(angle)),
                   middle.z);
  });
}

RenderOptions square(int side) {
  RenderOptions options;
  options.width = options.height = side;
  options.threads = 1;
  return options;
}

std::shared_ptr<const Texture> noise(int side, bool mip_levels) {
  Numbers numbers;
  Texture texture;
  TextureLevel image{side, side, {}};
  image.rgb.resize(3 * static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  for (float& value : image.rgb) value = static_cast<float>(std::floor(numbers.between(0, 256)));
  texture.levels.push_back(std::move(image));
  if (mip_levels) build_mip_levels(texture);
  return std::make_shared<const Texture>(std::move(texture));
}

Work filled(double pixels, const Material& material) {
  Work work{empty_scene(), square(static_cast<int>(std::lround(std::sqrt(pixels))))};
  work.scene.objects = {object_of(wall(200))};
  work.scene.objects[0].material = material;
  return work;
}

} // namespace refraster::cliffs
