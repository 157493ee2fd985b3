#pragma once
// Small triangles on the lattice, drawn into a tile a register of them at a time.

#include "raster/visibility/draw_snapped.h"
#include "raster/visibility/tile_list.h"

#include <array>
#include <cstdint>
#include <span>

namespace refraster {

/// Triangles whose boxes are so small that it is quicker to test all samples in them than to find where rows begin.
class SmallTriangles {
public:
  static constexpr int lanes = DepthTile::lanes;

  /// Whether a box is that small. A test costs a fraction of `lanes` of a few operations; a triangle's row, or a
  /// register of it, as many operations as a dozen tests, and the triangle itself as many again.
  static bool is_small(const TileEntry& box) {
    constexpr int side = 4; // pixels
    return box.right() - box.left() < side && box.bottom() - box.top() < side;
  }

  bool empty() const { return count_ == 0; }
  std::size_t size() const { return count_; }
  bool full() const { return count_ == lanes; }
  void add(const PlacedTriangle& triangle) { triangle_[count_++] = triangle; }

  /// Draws them all: each has area. Empty then. Returns how many pixels they cover, about.
  double draw(const PlacedVertex* vertices, const PixelRect& tile, std::span<const SamplePosition> samples,
              DepthTile& depths);

private:
  std::size_t count_ = 0;
  std::array<PlacedTriangle, lanes> triangle_;

  // Samples that are covered, to be written together: of how many triangles and at how many places each is covered, no
  // processor can guess, but once for many it may.
  struct Hits {
    static constexpr std::size_t places = 64 / lanes; // tested
    std::uint64_t set = 0;                            // bit lanes * place + lane
    std::size_t used = 0;                             // places
    std::array<std::int32_t, places * lanes> sample;
    std::array<double, places * lanes> z;
  };
  int write(Hits& hits, DepthTile& depths) const;
};

} // namespace refraster
