#pragma once
// The shapes of a scene file as meshes.

#include "io/scene_keys.h"

#include <cstdint>
#include <memory>

namespace refraster {

struct MeshCounts {
  std::uint64_t vertices = 0, triangles = 0;
  bool operator==(const MeshCounts&) const = default;
};

/// What a shape will have, before any of it is made.
MeshCounts mesh_counts(const Shape& shape);

std::shared_ptr<const Mesh> make_mesh(const Shape& shape);

} // namespace refraster
