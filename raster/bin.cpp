#include "raster/bin.h"

#include "raster/parallel.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>

namespace refraster {

Crop TileGrid::tile(std::size_t index) const {
  const int column = static_cast<int>(index % static_cast<std::size_t>(columns()));
  const int row = static_cast<int>(index / static_cast<std::size_t>(columns()));
  const int left = x + column * tile_size, top = y + row * tile_size;
  return {left, top, std::min(tile_size, x + width - left), std::min(tile_size, y + height - top)};
}

const ProjectiveTriangle& Bins::projective_triangle(std::uint32_t number) const {
  const auto at = std::lower_bound(projective.begin(), projective.end(), number,
                                   [](const NumberedProjective& p, std::uint32_t n) { return p.triangle < n; });
  assert(at != projective.end() && at->triangle == number);
  return at->set_up;
}

namespace {

// What becomes of a triangle, and the tiles it may touch: [left, right] x [top, bottom].
enum class Fate : std::uint8_t { not_finite, outside, degenerate, culled, between_samples, snapped, projective };
struct Placement {
  std::int16_t left = 0, right = -1, top = 0, bottom = -1;
};

class Binner {
public:
  Binner(const Scene& scene, const Geometry& geometry, const TileGrid& grid, int image_width, int image_height,
         std::span<const SamplePlace> samples)
      : scene_(scene), geometry_(geometry), grid_(grid), image_width_(image_width), image_height_(image_height) {
    const auto [x_low, x_high] =
        std::minmax_element(samples.begin(), samples.end(), [](auto& p, auto& q) { return p.x < q.x; });
    const auto [y_low, y_high] =
        std::minmax_element(samples.begin(), samples.end(), [](auto& p, auto& q) { return p.y < q.y; });
    tile_shift_ = std::countr_zero(static_cast<unsigned>(grid.tile_size));
    first_x_ = x_low->x, last_x_ = x_high->x, first_y_ = y_low->y, last_y_ = y_high->y;
  }

  // Classifies a triangle, and places it if it is drawn. `projective` is set when the fate is that.
  Fate place(const TriangleRef& ref, Placement& placement, ProjectiveTriangle& projective, bool& clipped) const {
    const WindowVertex v0 = geometry_.window[ref.vertex[0]];
    const WindowVertex v1 = geometry_.window[ref.vertex[1]];
    const WindowVertex v2 = geometry_.window[ref.vertex[2]];
    const int any = v0.outcode | v1.outcode | v2.outcode;
    if (any & outcode::not_finite) return Fate::not_finite;
    if (v0.outcode & v1.outcode & v2.outcode & outcode::sides) return Fate::outside;
    clipped = any & (outcode::unsnapped | outcode::near | outcode::far);
    const bool cull_back = scene_.objects[ref.object].cull == Cull::back;
    if (any & outcode::unsnapped) {
      std::array<Double4, 3> clip;
      const auto& corners = scene_.objects[ref.object].mesh->triangles[ref.triangle];
      for (std::size_t k = 0; k < 3; ++k)
        clip[k] =
            clip_position(geometry_.transforms[ref.object], scene_.objects[ref.object].mesh->positions[corners[k]]);
      const auto set_up = set_up_projective({v0, v1, v2}, clip, {image_width_, image_height_, scene_.camera.near});
      if (!set_up) return Fate::degenerate;
      if (cull_back && set_up->facing == Facing::back) return Fate::culled;
      projective = *set_up;
      placement = {0, static_cast<std::int16_t>(grid_.columns() - 1), 0, static_cast<std::int16_t>(grid_.rows() - 1)};
      return Fate::projective;
    }

    const std::int64_t area =
        static_cast<std::int64_t>(v1.x - v0.x) * (v2.y - v0.y) - static_cast<std::int64_t>(v2.x - v0.x) * (v1.y - v0.y);
    if (area == 0) return Fate::degenerate;
    if (cull_back && area > 0) return Fate::culled;
    // The pixels p whose samples may lie in the bounding box: 256 p + last >= min and 256 p + first <= max.
    const auto ceiling = [](std::int32_t a) { return (a + subpixels - 1) >> 8; };
    int left = ceiling(std::min({v0.x, v1.x, v2.x}) - last_x_), right = (std::max({v0.x, v1.x, v2.x}) - first_x_) >> 8;
    int top = ceiling(std::min({v0.y, v1.y, v2.y}) - last_y_), bottom = (std::max({v0.y, v1.y, v2.y}) - first_y_) >> 8;
    if (left > right || top > bottom) return Fate::between_samples;
    left = std::max(left - grid_.x, 0), right = std::min(right - grid_.x, grid_.width - 1);
    top = std::max(top - grid_.y, 0), bottom = std::min(bottom - grid_.y, grid_.height - 1);
    if (left > right || top > bottom) return Fate::outside;
    const auto tile = [&](int pixel) { return static_cast<std::int16_t>(static_cast<unsigned>(pixel) >> tile_shift_); };
    placement = {tile(left), tile(right), tile(top), tile(bottom)};
    return Fate::snapped;
  }

  // Calls visit(tile) for each tile that the triangle may touch. Where the bounding box holds many tiles, its lines
  // rule out those beside a long thin triangle.
  template <class Visit>
  void for_each_tile(std::uint32_t number, const Placement& p, const ProjectiveTriangle* projective,
                     Visit&& visit) const {
    if (p.left == p.right && p.top == p.bottom && !projective) {
      visit(static_cast<std::size_t>(p.top) * static_cast<std::size_t>(grid_.columns()) +
            static_cast<std::size_t>(p.left));
      return;
    }
    const auto each = [&](auto&& touches) {
      for (int row = p.top; row <= p.bottom; ++row)
        for (int column = p.left; column <= p.right; ++column) {
          const std::size_t tile = static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns()) +
                                   static_cast<std::size_t>(column);
          if (touches(tile)) visit(tile);
        }
    };
    const auto lines_touch = [&](const auto& lines, std::size_t tile) {
      const Crop c = grid_.tile(tile);
      const std::int32_t x0 = c.x * subpixels + first_x_, x1 = (c.x + c.width - 1) * subpixels + last_x_;
      const std::int32_t y0 = c.y * subpixels + first_y_, y1 = (c.y + c.height - 1) * subpixels + last_y_;
      return lines[0].most(x0, y0, x1, y1) >= 0 && lines[1].most(x0, y0, x1, y1) >= 0 &&
             lines[2].most(x0, y0, x1, y1) >= 0;
    };
    if (projective) {
      each([&](std::size_t tile) {
        return lines_touch(projective->piece[0].line, tile) ||
               (projective->pieces == 2 && lines_touch(projective->piece[1].line, tile));
      });
    } else if (p.right - p.left < 1 || p.bottom - p.top < 1 || (p.right - p.left) * (p.bottom - p.top) < 2) {
      each([](std::size_t) { return true; });
    } else {
      const auto set_up = set_up_snapped(window_corners(geometry_, triangle_ref(scene_, geometry_, number)));
      each([&](std::size_t tile) { return lines_touch(set_up->line, tile); });
    }
  }

private:
  const Scene& scene_;
  const Geometry& geometry_;
  const TileGrid& grid_;
  int image_width_, image_height_;
  int tile_shift_ = 0;                                               // tile_size is a power of two
  std::int32_t first_x_ = 0, last_x_ = 0, first_y_ = 0, last_y_ = 0; // the sample pattern's extent in a pixel
};

void count(FrameCounts& counts, Fate fate, bool clipped) {
  switch (fate) {
  case Fate::not_finite:
    ++counts.not_finite;
    return;
  case Fate::outside:
    ++counts.outside;
    return;
  case Fate::degenerate:
    ++counts.degenerate;
    return;
  case Fate::culled:
    ++counts.culled;
    return;
  case Fate::between_samples:
    ++counts.between_samples;
    return;
  case Fate::snapped:
  case Fate::projective:
    ++counts.drawn;
    counts.clipped += clipped ? 1 : 0;
    return;
  }
}

void add(FrameCounts& sum, const FrameCounts& part) {
  sum.not_finite += part.not_finite;
  sum.outside += part.outside;
  sum.degenerate += part.degenerate;
  sum.culled += part.culled;
  sum.between_samples += part.between_samples;
  sum.clipped += part.clipped;
  sum.drawn += part.drawn;
}

} // namespace

void bin_triangles(const Scene& scene, const Geometry& geometry, const TileGrid& grid, int image_width,
                   int image_height, std::span<const SamplePlace> samples, int threads, Bins& bins,
                   FrameCounts& counts) {
  const Binner binner(scene, geometry, grid, image_width, image_height, samples);
  const std::uint32_t triangles = geometry.triangles();
  counts.triangles = triangles;
  const std::size_t tiles = grid.tiles();

  // One run of consecutive triangles for each thread; two passes over each. The first counts, so that the second knows
  // where in each tile's list its run begins: the lists come out in submission order, whatever the number of runs.
  const auto runs = static_cast<std::size_t>(threads);
  const auto run_begin = [&](std::size_t run) {
    return static_cast<std::uint32_t>(static_cast<std::uint64_t>(triangles) * run / runs);
  };
  Buffer<Placement> placements;
  placements.resize_uninitialized(triangles);
  std::vector<std::uint64_t> fill(runs * tiles, 0); // first a count, then the place of the next entry
  std::vector<std::vector<NumberedProjective>> projective(runs);
  std::vector<FrameCounts> run_counts(runs);

  parallel_for(threads, runs, [&](std::size_t run, int) {
    std::uint64_t* const count_of = &fill[run * tiles];
    TriangleCursor cursor(scene, geometry);
    FrameCounts& here = run_counts[run];
    for (std::uint32_t number = run_begin(run); number < run_begin(run + 1); ++number) {
      ProjectiveTriangle set_up;
      bool clipped = false;
      Placement placement;
      const Fate fate = binner.place(cursor.at(number), placement, set_up, clipped);
      placements[number] = placement;
      count(here, fate, clipped);
      if (fate != Fate::snapped && fate != Fate::projective) continue;
      if (fate == Fate::projective) projective[run].push_back({number, set_up});
      binner.for_each_tile(number, placement, fate == Fate::projective ? &set_up : nullptr,
                           [&](std::size_t tile) { ++count_of[tile]; });
    }
  });

  bins.first.resize(tiles + 1);
  std::uint64_t total = 0;
  for (std::size_t tile = 0; tile < tiles; ++tile) {
    bins.first[tile] = total;
    for (std::size_t run = 0; run < runs; ++run) {
      const std::uint64_t here = fill[run * tiles + tile];
      fill[run * tiles + tile] = total;
      total += here;
    }
  }
  bins.first[tiles] = total;
  bins.triangles.resize_uninitialized(total);

  parallel_for(threads, runs, [&](std::size_t run, int) {
    std::uint64_t* const next = &fill[run * tiles];
    auto next_projective = projective[run].cbegin();
    for (std::uint32_t number = run_begin(run); number < run_begin(run + 1); ++number) {
      const ProjectiveTriangle* set_up = nullptr;
      if (next_projective != projective[run].cend() && next_projective->triangle == number)
        set_up = &(next_projective++)->set_up;
      if (placements[number].left > placements[number].right) continue;
      binner.for_each_tile(number, placements[number], set_up,
                           [&](std::size_t tile) { bins.triangles[next[tile]++] = number; });
    }
  });

  bins.projective.clear();
  for (std::size_t run = 0; run < runs; ++run) {
    add(counts, run_counts[run]);
    bins.projective.insert(bins.projective.end(), projective[run].begin(), projective[run].end());
  }
}

} // namespace refraster
