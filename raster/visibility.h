#pragma once
// Which triangle each sample of a tile sees: exact coverage, then depth. No number type of any rung is involved.

#include "raster/bin.h"

#include <cstdint>
#include <span>
#include <vector>

namespace refraster {

/// No triangle: the sample sees the background.
inline constexpr std::int32_t nothing = -1;

/// The nearest triangle of each sample of one tile. Reused from tile to tile.
class TileVisibility {
public:
  /// Rows are padded to whole SIMD registers; the padding is written to and never read.
  explicit TileVisibility(int tile_size);

  /// Decides every sample of the tile. `triangles` are the tile's, in submission order; samples refer to them by their
  /// place in that list. Depth test LESS: of equal depths the first drawn stays. Depth outside [-1, 1] is not drawn;
  /// both ends are.
  void decide(const Scene& scene, const Geometry& geometry, const Bins& bins, std::span<const std::uint32_t> triangles,
              const Crop& tile, std::span<const SamplePlace> samples);

  /// The triangle seen by sample `s` of the pixel (x, y), counted from the tile's corner: a place in `triangles`, or
  /// `nothing`.
  std::int32_t nearest(int s, int x, int y) const { return nearest_[index(s, x, y)]; }
  /// The same for a whole row of the tile.
  const std::int32_t* row(int s, int y) const { return &nearest_[index(s, 0, y)]; }
  /// Its z / w.
  double depth(int s, int x, int y) const { return depth_[index(s, x, y)]; }

private:
  std::size_t index(int s, int x, int y) const {
    return (static_cast<std::size_t>(s) * rows_ + static_cast<std::size_t>(y)) * stride_ + static_cast<std::size_t>(x);
  }
  // The part of a triangle's bounding box in the tile, in whole registers, and its first sample.
  struct Span {
    int sample, x_first, x_last, y_first, y_last;
    std::int32_t x_sample, y_sample;
  };
  enum class Coverage { tested, whole };

  void draw(const SnappedTriangle& triangle, std::int32_t place);
  template <Coverage coverage>
  void draw_rows(const SnappedTriangle& triangle, std::int32_t place, const Span& span);
  void draw(const ProjectiveTriangle& triangle, std::int32_t place);
  void draw(const ProjectivePiece& piece, std::int32_t place);

  std::size_t rows_, stride_;
  std::vector<double> depth_;
  std::vector<std::int32_t> nearest_;
  Crop tile_;
  std::span<const SamplePlace> samples_;
};

} // namespace refraster
