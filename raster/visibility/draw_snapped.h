#pragma once
// Triangles on the lattice, drawn into a tile: set up a register of them at a time, and then row by row, a register of
// samples at a time.

#include "raster/samples.h"
#include "raster/visibility/depth_tile.h"
#include "raster/visibility/row_spans.h"
#include "raster/visibility/snapped_setup.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace refraster {

/// Where a triangle comes from, and the slot it has among those that the tile may see.
struct PlacedTriangle {
  std::uint32_t vertex[3]; // in the list of vertices
  std::int32_t slot;
};

/// Corner k of as many triangles as a register has lanes; lanes to spare repeat the last triangle.
inline CornerLanes<DepthTile::lanes> corners_of(std::span<const PlacedTriangle> triangles, const PlacedVertex* vertices,
                                                std::size_t k) {
  return gather_corners<DepthTile::lanes>([&](int lane) -> const PlacedVertex& {
    return vertices[triangles[std::min(static_cast<std::size_t>(lane), triangles.size() - 1)].vertex[k]];
  });
}

/// Pixels of a tile, ends included, in each lane; none where left > right or top > bottom.
struct PixelBoxes {
  using Ints = VectorOf<std::int32_t, DepthTile::lanes>;
  Ints left, top, right, bottom;
};

/// The bounding boxes of triangles, subpixels of the window.
struct SubpixelBoxes {
  using Corner = CornerLanes<DepthTile::lanes>;
  using Ints = PixelBoxes::Ints;
  Ints x_min, y_min, x_max, y_max;

  SubpixelBoxes(const Corner& v0, const Corner& v1, const Corner& v2)
      : x_min(lesser(v0.x_subpixel, lesser(v1.x_subpixel, v2.x_subpixel))),
        y_min(lesser(v0.y_subpixel, lesser(v1.y_subpixel, v2.y_subpixel))),
        x_max(greater(v0.x_subpixel, greater(v1.x_subpixel, v2.x_subpixel))),
        y_max(greater(v0.y_subpixel, greater(v1.y_subpixel, v2.y_subpixel))) {}

  /// The pixels p of the tile with min <= 256 p + sample <= max.
  PixelBoxes pixels(const PixelRect& tile, const SamplePosition& sample) const {
    const auto first = [](const Ints& min, int offset, int begin) {
      return greater(((min - offset + (subpixels - 1)) >> 8) - begin, Ints{});
    };
    const auto last = [](const Ints& max, int offset, int begin, int size) {
      return lesser(((max - offset) >> 8) - begin, size - 1 - Ints{});
    };
    return {first(x_min, sample.x, tile.x), first(y_min, sample.y, tile.y), last(x_max, sample.x, tile.x, tile.width),
            last(y_max, sample.y, tile.y, tile.height)};
  }
};

class SnappedRasterizer {
public:
  static constexpr int lanes = DepthTile::lanes;

  /// Draws as many triangles as a register holds, or fewer: all have area. Returns how many pixels they cover, at most
  /// and about.
  double draw(std::span<const PlacedTriangle> triangles, const PlacedVertex* vertices, const PixelRect& tile,
              std::span<const SamplePosition> samples, DepthTile& depths);

private:
  using Row = DepthTile::Row;
  // Triangles ready for one sample of each pixel: numbers that are read triangle by triangle.
  template <class Number>
  using Each = std::array<Number, lanes>;
  struct Prepared {
    Each<std::int32_t> slot, left, top, right, bottom;                   // pixels of the tile
    std::array<Each<double>, 3> start, right_step, down_step, threshold; // of the three edge functions; by a pixel
    Each<double> z0, slope1, slope2, z_min, z_max;
    std::array<Each<double>, 4> edge, slope; // see SpanEdges: two to the left, two to the right
  };

  void draw_one(std::size_t lane, int s, DepthTile& depths);

  Prepared ready_;
  RowSpans spans_;
};

} // namespace refraster
