#pragma once
// Single vertices in the window, as tests make them and the vertex stage stores them.

#include "raster/vertex/transform.h"
#include "raster/vertex/vertex_stage.h"

#include <span>

namespace refraster::test {

/// The vertex stage of one vertex alone.
inline WindowVertex window_vertex(const Double4& clip, int width, int height) {
  const WindowLanes<double> v = window_lanes(clip, width, height);
  return {static_cast<std::int32_t>(v.x), static_cast<std::int32_t>(v.y), v.z, v.inverse_w,
          static_cast<std::uint8_t>(v.sides + outcode::not_finite * v.not_finite + outcode::unsnapped * v.unsnapped)};
}

inline void store(std::span<const WindowVertex> vertices, WindowVertices& stored) {
  stored.resize_uninitialized(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    stored.placed[i] = PlacedVertex::of(vertices[i]);
    stored.inverse_w[i] = vertices[i].inverse_w;
  }
}

} // namespace refraster::test
