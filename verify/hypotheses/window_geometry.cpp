#include "verify/hypotheses/window_geometry.h"

#include "raster/parallel.h"
#include "raster/shade/opacity.h"

#include <algorithm>
#include <optional>

namespace refraster::hypotheses {
namespace {

constexpr double planes_moved = 16;

Scene unculled(Scene scene) {
  for (Object& object : scene.objects) object.cull = Cull::none;
  scene.camera.near /= planes_moved, scene.camera.far *= planes_moved;
  return scene;
}

/// Sixteen samples a pixel: lists then hold triangles for all of a pixel, and not for its centre only.
RenderOptions whole_pixels(int width, int height, int threads) {
  RenderOptions options;
  options.width = width, options.height = height, options.threads = threads;
  options.samples = 16;
  options.tile_size = 32;
  return options;
}

/// A triangle of a tile's list, set up.
struct Candidate {
  std::uint32_t number = 0, object = 0;
  std::optional<SnappedTriangle> snapped;
  const ProjectiveTriangle* projective = nullptr;
  std::array<double, 3> inverse_w{}; // of the corners, as set up
  Facing facing = Facing::front;
  const Material* cut_outs = nullptr; // its material, if parts of that are cut out
};

Facing facing_of(const std::array<WindowVertex, 3>& v) {
  const auto difference = [](std::int32_t a, std::int32_t b) { return std::int64_t{a} - std::int64_t{b}; };
  const std::int64_t area =
      difference(v[1].x, v[0].x) * difference(v[2].y, v[0].y) - difference(v[2].x, v[0].x) * difference(v[1].y, v[0].y);
  return area > 0 ? Facing::back : Facing::front; // y runs downward
}

/// 1 / w there; nothing if it is not covered.
std::optional<double> covered(const Candidate& candidate, const Camera& camera, const WindowPoint& p) {
  if (candidate.snapped) {
    double sum = 0, weighted = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const SnappedEdge& edge = candidate.snapped->edge[k];
      if (!edge.covers(p.x, p.y)) return std::nullopt;
      const auto value = static_cast<double>(edge.at(p.x, p.y));
      sum += value, weighted += value * candidate.inverse_w[k];
    }
    return weighted / sum;
  }
  for (int i = 0; i < candidate.projective->pieces; ++i) {
    const ProjectivePiece& piece = candidate.projective->piece[static_cast<std::size_t>(i)];
    if (!piece.covers(p.x, p.y)) continue;
    // z / w = ((far + near) - 2 far near / w) / (far - near)
    const double z = piece.depth(p.x, p.y), near = camera.near, far = camera.far;
    return ((far + near) - z * (far - near)) / (2 * far * near);
  }
  return std::nullopt;
}

} // namespace

WindowGeometry::WindowGeometry(const Scene& scene, int width, int height, int threads)
    : scene_(unculled(scene)),
      options_(whole_pixels(width, height, threads)), context_{{scene_, options_}, geometry_, bins_} {
  FrameCounts counts;
  transform(context_, geometry_);
  bin_triangles(context_, geometry_, bins_, counts);
}

void WindowGeometry::add_covering(std::size_t tile, std::span<const std::size_t> in_tile,
                                  std::span<const WindowPoint> points,
                                  std::vector<std::vector<Covering>>& result) const {
  const PixelRect corner = tile_grid(context_).tile(tile);
  TriangleFinder finder(scene_, geometry_);
  const auto add = [&](const Candidate& candidate, std::size_t i) {
    const std::optional<double> inverse_w = covered(candidate, scene_.camera, points[i]);
    if (!inverse_w) return;
    Covering covering{candidate.number, candidate.object, *inverse_w, candidate.facing};
    if (candidate.cut_outs) {
      covering.opacity = opacity_at(context_, candidate.number, points[i].x / subpixels, points[i].y / subpixels);
      covering.threshold = candidate.cut_outs->opacity_threshold;
    }
    result[i].push_back(covering);
  };
  const auto add_entry = [&](const TileEntry& entry) {
    Candidate candidate;
    bool ready = false;
    for (const std::size_t i : in_tile) {
      if (entry.kind() == TileEntry::Kind::box) {
        const int x = points[i].x / subpixels - corner.x, y = points[i].y / subpixels - corner.y;
        if (x < entry.left() || x > entry.right() || y < entry.top() || y > entry.bottom()) continue;
      }
      if (!ready) {
        const TriangleRef ref = finder.at(entry.triangle);
        candidate.number = entry.triangle, candidate.object = ref.object;
        const Material& material = material_of(scene_.objects[ref.object], ref.triangle);
        if (material.has_cut_outs()) candidate.cut_outs = &material;
        if (entry.kind() == TileEntry::Kind::box) {
          const std::array<WindowVertex, 3> window = window_corners(geometry_, ref);
          candidate.snapped = set_up_snapped(window);
          if (!candidate.snapped) return;
          candidate.facing = facing_of(window);
          for (std::size_t k = 0; k < 3; ++k) candidate.inverse_w[k] = window[candidate.snapped->corner[k]].inverse_w;
        } else {
          candidate.projective = &bins_.projective_triangle(entry.triangle);
          candidate.facing = candidate.projective->facing;
        }
        ready = true;
      }
      add(candidate, i);
    }
  };
  bins_.lists.for_each_piece(tile, [&](std::span<const TileEntry> entries) {
    for (const TileEntry& entry : entries) add_entry(entry);
  });
}

std::vector<std::vector<Covering>> WindowGeometry::covering(std::span<const WindowPoint> points) const {
  std::vector<std::vector<Covering>> result(points.size());
  const TileGrid grid = tile_grid(context_);
  std::vector<std::vector<std::size_t>> in_tile(grid.tiles());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int x = points[i].x / subpixels, y = points[i].y / subpixels;
    if (points[i].x < 0 || points[i].y < 0 || x >= grid.width || y >= grid.height) continue;
    const int tile = y / grid.tile_size * grid.columns() + x / grid.tile_size;
    in_tile[static_cast<std::size_t>(tile)].push_back(i);
  }
  parallel_for(context_.threads, in_tile.size(), [&](std::size_t tile, int) {
    if (!in_tile[tile].empty()) add_covering(tile, in_tile[tile], points, result);
  });
  return result;
}

} // namespace refraster::hypotheses
