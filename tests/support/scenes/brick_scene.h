#pragma once
// A scene whose normals are turned by maps that are made here: a wall of bricks.

#include <refraster/mesh.h>
#include <refraster/scene.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace refraster {

/// Heights of bricks in [0, 1], a texel each, rows from below: four courses of two bricks, every other one moved by
/// half a brick, with edges that slope down to the mortar.
inline std::vector<double> brick_heights(int side) {
  std::vector<double> heights;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double v = (y + 0.5) / side * 4, u = (x + 0.5) / side * 2 + 0.5 * (static_cast<int>(v) % 2);
      const double across = u - std::floor(u), up = v - std::floor(v);
      const double from_edge = std::min({2 * across, 2 * (1 - across), up, 1 - up}); // 1: the height of a brick
      heights.push_back(std::clamp((from_edge - 0.06) / 0.12, 0.0, 1.0));
    }
  return heights;
}

/// A texture of numbers in [0, 1], three a texel, of 8 bits.
inline std::shared_ptr<const Texture> texture_of(int side, const std::vector<double>& rgb) {
  auto texture = std::make_shared<Texture>();
  TextureLevel& image = texture->levels.emplace_back();
  image.width = image.height = side;
  for (const double value : rgb) image.rgb.push_back(static_cast<float>(std::nearbyint(255 * value)));
  build_mip_levels(*texture);
  return texture;
}

inline std::shared_ptr<const Texture> brick_height_texture(int side) {
  std::vector<double> rgb;
  for (const double height : brick_heights(side)) rgb.insert(rgb.end(), 3, height);
  return texture_of(side, rgb);
}

/// The normals of such bricks that stand out by `depth` texels: red along u, green along v, 1/2 is 0.
inline std::shared_ptr<const Texture> brick_normal_texture(int side, double depth) {
  const std::vector<double> heights = brick_heights(side);
  const auto height = [&](int x, int y) {
    return heights[static_cast<std::size_t>((y + side) % side * side + (x + side) % side)];
  };
  std::vector<double> rgb;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const Double3 n(-(height(x + 1, y) - height(x - 1, y)) / 2 * depth,
                      -(height(x, y + 1) - height(x, y - 1)) / 2 * depth, 1);
      const double size = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
      for (int c = 0; c < 3; ++c) rgb.push_back(0.5 + 0.5 * n[c] / size);
    }
  return texture_of(side, rgb);
}

/// Which maps turn the normals.
enum class BrickMaps { normals, heights, both };

/// A ball and a tube of bricks, whose texture coordinates run round them, lit from the upper left.
inline Scene brick_scene(TextureFilter filter, BrickMaps maps) {
  constexpr int side = 64;
  Scene scene;
  scene.camera.position = {0.2, 0.8, 4.2};
  scene.camera.target = {0, 0, 0};
  scene.background = {0.05, 0.06, 0.08};
  scene.point_lights = {{{-3, 4, 5}, {0.9, 0.85, 0.8}, 1, 0, 0}};
  scene.direction_lights = {{{-1, -0.5, -1}, {0.15, 0.2, 0.25}}};
  BlinnPhong function;
  function.ka = Double3(0.04), function.kd = {0.65, 0.4, 0.32}, function.ks = Double3(0.25), function.glossiness = 24;
  const auto add = [&](Mesh mesh, const Double3& position, const Double3& scale) {
    add_tangents(mesh);
    Object object;
    object.name = "bricks " + std::to_string(scene.objects.size() + 1);
    object.mesh = std::make_shared<const Mesh>(std::move(mesh));
    object.position = position, object.scale = scale;
    object.rotate_degrees = {20, 15, 5};
    Material& material = object.material;
    material.fragment_function = function;
    for (TextureMap* const map : {&material.normal_map, &material.bump_map}) map->filter = filter, map->scale = {3, 2};
    if (maps != BrickMaps::heights) material.normal_map.texture = brick_normal_texture(side, 4);
    if (maps != BrickMaps::normals) material.bump_map.texture = brick_height_texture(side);
    material.bump_scale = maps == BrickMaps::both ? 1 : 4;
    scene.objects.push_back(std::move(object));
  };
  add(sphere_mesh(32, 16), {-1.05, 0.1, 0}, Double3(0.95));
  add(torus_mesh(40, 20, 0.45), {1.15, -0.1, 0}, {0.75, 0.75, -0.75}); // which mirrors
  return scene;
}

} // namespace refraster
