#include "io/scene/shape_mesh.h"

#include <refraster/mesh.h>

namespace refraster {
namespace {

MeshCounts grid_counts(int columns, int rows) {
  const auto c = static_cast<std::uint64_t>(columns), r = static_cast<std::uint64_t>(rows);
  return {(c + 1) * (r + 1), 2 * c * r};
}

} // namespace

MeshCounts mesh_counts(const Shape& shape) {
  struct Count {
    MeshCounts operator()(const SphereShape& s) const {
      const MeshCounts grid = grid_counts(s.segments, s.rings - 2);
      const auto caps = 2 * static_cast<std::uint64_t>(s.segments); // a triangle, with a pole of its own, each
      return {grid.vertices + caps, grid.triangles + caps};
    }
    MeshCounts operator()(const CubeShape&) const { return {24, 12}; }
    MeshCounts operator()(const PlaneShape& s) const { return grid_counts(s.segments, s.segments); }
    MeshCounts operator()(const TorusShape& s) const { return grid_counts(s.segments, s.rings); }
    MeshCounts operator()(const KnotShape& s) const { return grid_counts(s.segments, s.rings); }
  };
  return std::visit(Count{}, shape);
}

std::shared_ptr<const Mesh> make_mesh(const Shape& shape) {
  struct Make {
    Mesh operator()(const SphereShape& s) const { return sphere_mesh(s.segments, s.rings); }
    Mesh operator()(const CubeShape&) const { return cube_mesh(); }
    Mesh operator()(const PlaneShape& s) const { return plane_mesh(s.segments); }
    Mesh operator()(const TorusShape& s) const { return torus_mesh(s.segments, s.rings, s.tube_radius); }
    Mesh operator()(const KnotShape& s) const { return knot_mesh(s.segments, s.rings, s.tube_radius); }
  };
  return std::make_shared<const Mesh>(std::visit(Make{}, shape));
}

} // namespace refraster
