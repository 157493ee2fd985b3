#pragma once
// What families are built from.

#include <refraster/mesh.h>
#include <refraster/scene.h>

#include "bench/cliffs/families.h"

#include <cstdint>
#include <memory>
#include <random>
#include <utility>

namespace refraster::cliffs {

/// The same numbers everywhere.
class Numbers {
public:
  /// In [lo, hi).
  double between(double lo, double hi) { return lo + (hi - lo) * (static_cast<double>(engine_()) * 0x1p-32); }
  Double3 between(const Double3& lo, const Double3& hi);

private:
  std::mt19937 engine_;
};

/// The eye at (0, 0, distance), looking at the origin with 90 degrees: of the plane z = 0 a square image sees
/// [-distance, distance]^2. A point light beside it, and no object.
Scene empty_scene(double distance = 1);

/// A dull-edged plastic, of Blinn-Phong.
BlinnPhong plastic();

Object object_of(Mesh mesh);
Object object_of(std::shared_ptr<const Mesh> mesh);

/// Triangles without shared vertices, facing +Z, each made by corner(i, k), k from 0 to 2.
template <class Corner>
Mesh soup(std::uint32_t triangles, const Corner& corner) {
  Mesh mesh;
  mesh.positions.reserve(3 * std::size_t{triangles}), mesh.triangles.reserve(triangles);
  for (std::uint32_t i = 0; i < triangles; ++i) {
    for (int k = 0; k < 3; ++k) {
      const Double3 p = corner(i, k);
      mesh.positions.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z));
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  mesh.normals.assign(mesh.positions.size(), Float3(0, 0, 1));
  return mesh;
}

/// With another mesh for the first object.
void change_mesh(Work& work, auto&& change) {
  Mesh mesh = *work.scene.objects[0].mesh;
  change(mesh);
  work.scene.objects[0].mesh = std::make_shared<const Mesh>(std::move(mesh));
}

/// plane_mesh(), upright in z = 0 and facing +Z, with about so many triangles.
Mesh wall(double triangles);

/// So many triangles of about `pixels` pixels across, anywhere in an image of `side` pixels that empty_scene() sees, at
/// depths between z = -0.5 and z = 0.
Mesh scattered(std::uint32_t triangles, double pixels, int side);

/// A square image of one sample.
RenderOptions square(int side);

/// A texture of noise, with or without its mip levels.
std::shared_ptr<const Texture> noise(int side, bool mip_levels);

/// A wall that fills a square image with about a quarter of a million pixels, times `pixels` / 2^18.
Work filled(double pixels, const Material& material);

} // namespace refraster::cliffs
