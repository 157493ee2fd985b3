#pragma once
// Triangles on the lattice, drawn into a tile: set up a register of them at a time, and then row by row, a register of
// samples at a time.

#include "raster/samples.h"
#include "raster/visibility/depth_tile.h"
#include "raster/visibility/row_spans.h"
#include "raster/visibility/snapped_setup.h"

#include <array>
#include <cstdint>
#include <span>

namespace refraster {

/// Where a triangle comes from, and the slot it has among those that the tile may see.
struct PlacedTriangle {
  std::uint32_t vertex[3]; // in the list of vertices
  std::int32_t slot;
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
