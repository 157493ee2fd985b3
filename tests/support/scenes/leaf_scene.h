#pragma once
// Leaves before a ground: surfaces of which an opacity map cuts out most, of all sizes that triangles have.

#include <refraster/mesh.h>
#include <refraster/scene.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>

namespace refraster {

/// The opacity of a leaf, one in the middle and falling to 0 at its outline, with a slit along it; of 8 bits.
inline Texture leaf_opacity(int size) {
  Texture texture;
  TextureLevel image{size, size, {}};
  for (int j = 0; j < size; ++j)
    for (int i = 0; i < size; ++i) {
      const double x = (i + 0.5) / size * 2 - 1, y = (j + 0.5) / size * 2 - 1;
      const double inside = 0.8 * (1 - y * y) - std::abs(x); // a pointed oval
      const double slit = std::abs(x) - 0.06;
      const double value = std::min(std::max(std::min(inside, y < 0.2 ? slit : inside) * 4 + 0.5, 0.0), 1.0);
      for (int c = 0; c < 3; ++c) image.rgb.push_back(static_cast<float>(std::lround(255 * value)));
    }
  texture.levels.push_back(std::move(image));
  return texture;
}

/// A card in the plane z = 0, of `cuts` x `cuts` quads, with the leaf once.
inline Mesh leaf_card(int cuts) {
  Mesh mesh = plane_mesh(cuts);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Float3 p = mesh.positions[v];
    mesh.positions[v] = {p.x, -p.z, 0};
    mesh.normals[v] = {0, 0, 1};
    mesh.uvs[v] = {p.x / 2 + 0.5f, 0.5f - p.z / 2};
  }
  return mesh;
}

/// Leaves that stand before, behind and through one another, one made of triangles below a pixel, over a ground with a
/// texture; beside them a lattice that reaches behind the eye.
inline Scene leaf_scene(TextureFilter filter, double threshold = 0.5) {
  Scene scene;
  scene.camera = {{0.4, 1.1, 4.2}, {0, 0.2, 0}, {0, 1, 0}, 45, 0.1, 60};
  scene.background = {0.35, 0.45, 0.6};
  scene.point_lights = {{{-3, 4, 5}, {1.1, 1, 0.9}, 1, 0, 0}};

  Texture opacity = leaf_opacity(32);
  if (filter == TextureFilter::trilinear) build_mip_levels(opacity);
  TextureMap map;
  map.texture = std::make_shared<const Texture>(std::move(opacity)), map.filter = filter;
  const auto add = [&](std::string name, Mesh mesh, const Double3& position, const Double3& rotate,
                       const Double3& scale, const Double3& colour) -> Object& {
    Phong function;
    function.ka = 0.3 * colour, function.kd = 0.7 * colour, function.ks = Double3(0.2), function.glossiness = 12;
    Object& object = scene.objects.emplace_back();
    object.name = std::move(name), object.mesh = std::make_shared<const Mesh>(std::move(mesh));
    object.position = position, object.rotate_degrees = rotate, object.scale = scale;
    object.two_sided = TwoSided::yes;
    object.material.fragment_function = function;
    return object;
  };
  const auto cut_out = [&](Object& object) -> Object& {
    object.material.opacity_map = map, object.material.opacity_threshold = threshold;
    return object;
  };
  cut_out(add("leaf", leaf_card(1), {-0.6, 0.3, 0.6}, {0, 20, 15}, Double3(0.9), {0.3, 0.8, 0.2}));
  cut_out(add("leaf through it", leaf_card(2), {-0.5, 0.3, 0.6}, {0, -50, -20}, Double3(0.8), {0.8, 0.7, 0.1}));
  cut_out(
      add("leaf of many triangles", leaf_card(40), {0.9, 0.4, -0.2}, {10, -15, -30}, Double3(0.9), {0.9, 0.3, 0.1}));
  Object& lattice = cut_out(add("lattice", leaf_card(1), {1.3, 0.2, 1}, {0, -80, 0}, {9, 1.4, 1}, {0.5, 0.4, 0.4}));
  lattice.material.opacity_map.scale = {9, 2};
  Object& ground = add("ground", plane_mesh(1), {0, -0.8, -2}, {0, 10, 0}, {8, 1, 8}, {0.9, 0.9, 0.9});
  Texture tiles;
  TextureLevel image{8, 8, {}};
  for (int i = 0; i < 3 * 64; ++i) image.rgb.push_back(static_cast<float>(40 + i * 71 % 200));
  tiles.levels.push_back(std::move(image));
  ground.material.diffuse_map.texture = std::make_shared<const Texture>(std::move(tiles));
  ground.material.diffuse_map.scale = Double2(6);
  return scene;
}

} // namespace refraster
