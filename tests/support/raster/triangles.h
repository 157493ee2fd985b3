#pragma once
// Triangles without a scene file: what the raster tests put through set-up, coverage and depth.

#include "raster/visibility/setup.h"
#include "raster/visibility/visibility.h"
#include "tests/support/raster/scalar_triangle.h"
#include "tests/support/raster/window_vertex.h"

#include <array>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace refraster::test {

/// A vertex already on the lattice, at depth z, w = 1.
inline WindowVertex lattice_vertex(std::int32_t x, std::int32_t y, double z = 0, double w = 1) {
  WindowVertex v{};
  v.x = x, v.y = y, v.z = z, v.inverse_w = 1 / w;
  return v;
}

/// Either kind of set-up, chosen as the pipeline does.
struct AnyTriangle {
  std::variant<SnappedTriangle, ProjectiveTriangle> set_up;
  ScalarTriangle scalar{}; // the same as a SnappedTriangle, which has edges only

  /// body(lines, facing) for each of the triangles that are drawn for this one.
  template <class Body>
  void for_each_part(Body&& body) const {
    if (const auto* snapped = std::get_if<SnappedTriangle>(&set_up)) return body(snapped->edge, scalar.facing);
    const auto& projective = std::get<ProjectiveTriangle>(set_up);
    for (std::size_t i = 0; i < static_cast<std::size_t>(projective.pieces); ++i)
      body(projective.piece[i].edge, projective.piece[i].facing);
  }
  bool covers(std::int32_t x, std::int32_t y) const {
    bool covered = false;
    for_each_part([&](const auto& line, Facing) {
      covered |= line[0].covers(x, y) && line[1].covers(x, y) && line[2].covers(x, y);
    });
    return covered;
  }
  double depth(std::int32_t x, std::int32_t y) const {
    if (std::holds_alternative<SnappedTriangle>(set_up)) return scalar.depth(x, y);
    const auto& projective = std::get<ProjectiveTriangle>(set_up);
    const bool first = projective.pieces == 1 || projective.piece[0].edge[1].covers(x, y); // edge[1] is between the two
    return projective.piece[first ? 0 : 1].depth(x, y);
  }
};

/// All corners on the lattice.
inline std::optional<AnyTriangle> set_up_on_lattice(const std::array<WindowVertex, 3>& v) {
  if (const auto t = set_up_snapped(v)) return AnyTriangle{*t, set_up_scalar(v).value()};
  return std::nullopt;
}

/// Nothing is cut off in front of `near`: by default, nothing that any test looks at.
inline std::optional<AnyTriangle> set_up(const std::array<Double4, 3>& clip, int width, int height,
                                         double near = 0x1p-120) {
  std::array<WindowVertex, 3> v;
  for (std::size_t k = 0; k < 3; ++k) v[k] = window_vertex(clip[k], width, height);
  const int any = v[0].outcode | v[1].outcode | v[2].outcode;
  if (any & outcode::not_finite) return std::nullopt;
  if (any & outcode::unsnapped) {
    if (auto t = set_up_projective(v, clip, {width, height, near})) return AnyTriangle{*t};
    return std::nullopt;
  }
  return set_up_on_lattice(v);
}

/// A frame of lattice triangles that never saw a camera: for driving binning and TileVisibility directly.
struct LatticeFrame {
  Scene scene;
  Geometry geometry;

  explicit LatticeFrame(const std::vector<std::array<WindowVertex, 3>>& triangles) {
    auto mesh = std::make_shared<Mesh>();
    std::vector<WindowVertex> vertices;
    for (const auto& t : triangles) {
      const auto first = static_cast<std::uint32_t>(vertices.size());
      mesh->triangles.push_back({first, first + 1, first + 2});
      vertices.insert(vertices.end(), t.begin(), t.end());
    }
    mesh->positions.resize(vertices.size()); // never read, but indices must name one
    store(vertices, geometry.window);
    geometry.first_vertex = {0, static_cast<std::uint32_t>(geometry.window.size())};
    geometry.first_triangle = {0, static_cast<std::uint32_t>(triangles.size())};
    scene.objects.emplace_back();
    scene.objects[0].mesh = mesh;
  }

  /// Bins the triangles for a grid of one tile, and decides that tile. `tile` is square, with a power of two of pixels.
  void decide(const PixelRect& tile, int samples, TileVisibility& visibility) const {
    RenderOptions options;
    options.width = options.height = max_image_side;
    options.crop = {tile};
    options.samples = samples;
    options.threads = 1;
    options.tile_size = tile.width;
    Bins bins;
    FrameCounts counts;
    const FrameContext context{{scene, options}, geometry, bins};
    bin_triangles(context, geometry, bins, counts);
    visibility.decide(context, 0, tile);
  }
};

/// The number of the triangle that a sample sees, or -1.
inline std::int64_t seen_triangle(const TileVisibility& visibility, int s, int x, int y) {
  const std::int32_t place = visibility.nearest(s, x, y);
  return place == nothing ? -1 : std::int64_t{visibility.triangles()[static_cast<std::size_t>(place)]};
}

} // namespace refraster::test
