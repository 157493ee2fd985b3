#pragma once
// Meshes, points on them and lights, as shadows are tested with; and what is in the light, in rational numbers.

#include "raster/shadow/triangle_tree.h"
#include "tests/support/random.h"
#include "tests/support/raster/exact_triangle.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace refraster::test {

/// A mesh that grows.
struct MeshParts {
  std::vector<Double3> position;
  std::vector<std::array<std::uint32_t, 3>> triangle;

  std::uint32_t add(const Double3& p) {
    position.push_back(p);
    return static_cast<std::uint32_t>(position.size() - 1);
  }
  void add(const WorldTriangle& t) { triangle.push_back({add(t[0]), add(t[1]), add(t[2])}); }

  WorldMesh mesh() const {
    WorldMesh result;
    result.position.resize_uninitialized(position.size());
    result.triangle.resize_uninitialized(triangle.size());
    for (std::size_t i = 0; i < position.size(); ++i) result.position[i] = position[i];
    for (std::size_t i = 0; i < triangle.size(); ++i) result.triangle[i] = triangle[i];
    return result;
  }
};

/// What a mesh is like.
enum class MeshKind {
  closed,     // a polyhedron without holes, corners anywhere
  open,       // a sheet of neighbours
  loose,      // triangles that have nothing to do with each other
  degenerate, // without area, or nearly, and some that are not
  touching,   // on a small lattice: many share planes, edges and corners, and cross each other
  count_
};

/// A coordinate of a lattice of 5.
inline double lattice(Random& random) {
  return random.below(5) - 2;
}
inline Double3 lattice_point(Random& random) {
  const double x = lattice(random), y = lattice(random), z = lattice(random);
  return {x, y, z};
}
inline Double3 place(Random& random, double size) {
  const double x = random.uniform(-size, size), y = random.uniform(-size, size), z = random.uniform(-size, size);
  return {x, y, z};
}

inline MeshParts random_mesh(Random& random, MeshKind kind) {
  MeshParts mesh;
  const auto any = [&] { return place(random, 2); };
  switch (kind) {
  case MeshKind::closed: {
    // Two rings of corners with a pole at either end.
    const int sides = 3 + random.below(4);
    const std::uint32_t top = mesh.add(Double3(0, 0, 2) + 0.3 * any()),
                        bottom = mesh.add(Double3(0, 0, -2) + 0.3 * any());
    constexpr double around[][2] = {{1, 0}, {0.5, 0.9}, {-0.5, 0.9}, {-1, 0}, {-0.5, -0.9}, {0.5, -0.9}};
    std::uint32_t ring[2][6];
    for (int r = 0; r < 2; ++r)
      for (int i = 0; i < sides; ++i)
        ring[r][i] = mesh.add(Double3(2 * around[i][0], 2 * around[i][1], 1 - 2 * r) + 0.3 * any());
    for (int i = 0; i < sides; ++i) {
      const int j = (i + 1) % sides;
      mesh.triangle.push_back({top, ring[0][i], ring[0][j]});
      mesh.triangle.push_back({ring[0][i], ring[1][i], ring[0][j]});
      mesh.triangle.push_back({ring[0][j], ring[1][i], ring[1][j]});
      mesh.triangle.push_back({bottom, ring[1][j], ring[1][i]});
    }
    break;
  }
  case MeshKind::open: {
    const bool flat = random.below(2) == 0;
    constexpr int n = 4;
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) mesh.add(Double3(x - 1.5, y - 1.5, flat ? 0.7 : random.uniform(-1, 1)));
    for (std::uint32_t y = 0; y + 1 < n; ++y)
      for (std::uint32_t x = 0; x + 1 < n; ++x) {
        const std::uint32_t at = y * n + x;
        mesh.triangle.push_back({at, at + 1, at + n}), mesh.triangle.push_back({at + 1, at + n + 1, at + n});
      }
    break;
  }
  case MeshKind::loose:
    for (int i = 0; i < 16; ++i) mesh.add(WorldTriangle{any(), any(), any()});
    break;
  case MeshKind::degenerate:
    for (int i = 0; i < 16; ++i) {
      const Double3 a = any(), b = any();
      switch (random.below(5)) {
      case 0:
        mesh.add(WorldTriangle{a, a, a});
        break;
      case 1:
        mesh.add(WorldTriangle{a, b, b});
        break;
      case 2:
        mesh.add(WorldTriangle{a, b, 0.5 * (a + b)});
        break;
      case 3: // a needle, as thin as can be
        mesh.add(WorldTriangle{a, b, 0.5 * (a + b) + 0x1p-52 * any()});
        break;
      default:
        mesh.add(WorldTriangle{a, b, any()});
      }
    }
    break;
  default:
    for (int i = 0; i < 16; ++i)
      mesh.add(WorldTriangle{lattice_point(random), lattice_point(random), lattice_point(random)});
  }
  return mesh;
}

/// A point of a triangle: inside, on an edge, in a corner; weights of any size.
inline SurfacePoint random_point(Random& random, const WorldTriangle& triangle) {
  SurfacePoint point{triangle, {}};
  do
    for (double& w : point.weight)
      w = random.below(4) == 0 ? 0 : random.below(2) == 0 ? 1 + random.below(3) : random.log_uniform(1e-9, 1e3);
  while (!(point.weight[0] + point.weight[1] + point.weight[2] > 0));
  return point;
}

inline LightPlace random_light(Random& random, const MeshParts& mesh) {
  LightPlace light{random.below(3) == 0 ? LightPlace::Kind::direction : LightPlace::Kind::point, {}};
  const auto corner = [&] {
    return mesh.position[static_cast<std::size_t>(random.below(static_cast<int>(mesh.position.size())))];
  };
  do switch (random.below(4)) {
    case 0:
      light.at = place(random, random.log_uniform(0.5, 1e3));
      break;
    case 1:
      light.at = lattice_point(random);
      break;
    case 2: // in the plane of many, or in a corner
      light.at = random.below(2) == 0 ? corner() : corner() + corner() - corner();
      break;
    default:
      light.at = Double3(0, 0, 0), light.at[random.below(3)] = 3;
    }
  while (light.kind == LightPlace::Kind::direction && light.at == Double3(0));
  return light;
}

// What is crossed, by Cramer's rule.

inline RationalVec3 operator-(const RationalVec3& a, const RationalVec3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline RationalVec3 rational_point(const SurfacePoint& point) {
  RationalVec3 sum{};
  Rational weights;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational w(point.weight[k]);
    const RationalVec3 corner = rational(point.corner[k]);
    for (std::size_t c = 0; c < 3; ++c) sum[c] += w * corner[c];
    weights += w;
  }
  for (Rational& c : sum) c /= weights;
  return sum;
}

/// Whether p + t (way) = a + v (b - a) + w (c - a) has one solution, which has 0 < t, t < 1 on the way to a point, and
/// 0 <= v, w, 1 - v - w.
inline bool crosses_in_rationals(const RationalVec3& p, const LightPlace& light, const WorldTriangle& triangle) {
  const bool is_point = light.kind == LightPlace::Kind::point;
  const RationalVec3 way = is_point ? rational(light.at) - p : rational(light.at);
  const RationalVec3 a = rational(triangle[0]), ab = rational(triangle[1]) - a, ac = rational(triangle[2]) - a;
  const RationalVec3 back{-way[0], -way[1], -way[2]};
  const auto weight = combination(p - a, back, ab, ac);
  if (!weight) return false;
  const auto& [t, v, w] = *weight;
  return t > 0 && (!is_point || t < 1) && v >= 0 && w >= 0 && v + w <= 1;
}

} // namespace refraster::test
