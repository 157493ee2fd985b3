#pragma once
// The shapes of a scene file as meshes.

#include "io/scene/scene_keys.h"

#include <cstdint>
#include <memory>

namespace refraster {

struct MeshCounts {
  std::uint64_t vertices = 0, triangles = 0;
  bool operator==(const MeshCounts&) const = default;

  /// Of the mesh: positions, normals and UVs of its vertices, indices of its triangles.
  std::uint64_t size_bytes() const {
    return vertices * (2 * sizeof(Float3) + sizeof(Float2)) + triangles * sizeof(Mesh::triangles[0]);
  }
};

/// What a shape will have, before any of it is made.
MeshCounts mesh_counts(const Shape& shape);

std::shared_ptr<const Mesh> make_mesh(const Shape& shape);

} // namespace refraster
