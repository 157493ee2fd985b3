#pragma once
// Which triangle each sample of a tile sees: exact coverage, then depth. No number type of any rung is involved.

#include "raster/bin.h"
#include "raster/snapped_lanes.h"

#include <cstdint>
#include <span>
#include <vector>

namespace refraster {

/// No triangle: the sample sees the background.
inline constexpr std::int32_t nothing = -1;

/// The nearest triangle of each sample of one tile. Reused from tile to tile.
class TileVisibility {
public:
  explicit TileVisibility(int tile_size);

  /// Decides every sample of a tile: number `index` of the grid that was binned, with the pixels `tile`. Depth test
  /// LESS: of equal depths the first submitted stays. Depth outside [-1, 1] is not drawn; both ends are.
  void decide(const Scene& scene, const Geometry& geometry, const Bins& bins, std::size_t index, const Crop& tile,
              std::span<const SamplePlace> samples);

  /// The numbers of the triangles that samples may refer to, in submission order.
  std::span<const std::uint32_t> triangles() const { return triangles_; }
  /// The triangle seen by sample `s` of the pixel (x, y), counted from the tile's corner: its place in triangles(), or
  /// `nothing`.
  std::int32_t nearest(int s, int x, int y) const { return nearest_[at(s, x, y)]; }
  /// The same for a whole row of the tile.
  const std::int32_t* row(int s, int y) const { return &nearest_[at(s, 0, y)]; }
  /// Its z / w.
  double depth(int s, int x, int y) const { return depth_[at(s, x, y)]; }

private:
  static constexpr int lanes = NumberTraits<Native<double>>::lanes;
  using Row = Native<double>; // as many neighbouring samples as a register holds

  std::size_t at(int s, int x, int y) const {
    return (static_cast<std::size_t>(s) * rows_ + static_cast<std::size_t>(y)) * stride_ + static_cast<std::size_t>(x);
  }
  std::int32_t place_of(std::uint32_t triangle);
  void see(std::size_t sample, double z, std::int32_t place);

  // A triangle whose bounding box is to be searched.
  struct Boxed {
    std::uint32_t triangle;
    std::int32_t place;
    double z_least;
  };
  struct Drawn;
  void draw(std::span<const Boxed> boxed, const Scene& scene, const Geometry& geometry);
  void draw(const Drawn& triangle, std::size_t lane, int s);
  void draw(const ProjectiveTriangle& triangle, std::int32_t place);
  void draw(const ProjectivePiece& piece, std::int32_t place);

  // Rows are followed by room for a register, which is written to and never read.
  std::size_t rows_, stride_;
  std::vector<double> depth_;
  std::vector<std::int32_t> nearest_;
  std::vector<std::uint32_t> triangles_;
  std::vector<Boxed> boxed_;
  Crop tile_;
  std::span<const SamplePlace> samples_;
};

} // namespace refraster
