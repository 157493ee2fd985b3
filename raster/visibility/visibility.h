#pragma once
// Which triangle each sample of a tile sees: exact coverage, then depth. No number type of any precision is involved.

#include "raster/visibility/bin.h"
#include "raster/visibility/cut_outs.h"
#include "raster/visibility/tiny/draw_small.h"
#include "raster/visibility/draw_snapped.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace refraster {

/// The nearest triangle of each sample of one tile. Reused from tile to tile.
class TileVisibility {
public:
  explicit TileVisibility(int tile_size) : depths_(tile_size) {}

  /// Decides every sample of a tile: number `index` of the grid that was binned, with the pixels `tile`. Depth test
  /// LESS: of equal depths the first submitted stays. Depth outside [-1, 1] is not drawn; both ends are.
  void decide(const FrameContext& context, std::size_t index, const PixelRect& tile);

  /// The numbers of the triangles that samples may refer to, in submission order.
  std::span<const std::uint32_t> triangles() const { return triangles_; }
  /// The triangle seen by sample `s` of the pixel (x, y), counted from the tile's corner: its slot in triangles(), or
  /// `nothing`.
  std::int32_t nearest(int s, int x, int y) const { return depths_.nearest(depths_.at(s, x, y)); }
  /// The same for a whole row of the tile.
  const std::int32_t* row(int s, int y) const { return depths_.nearest_row(depths_.at(s, 0, y)); }
  /// Its z / w.
  double depth(int s, int x, int y) const { return depths_.depth(depths_.at(s, x, y)); }

private:
  // A triangle whose bounding box is to be searched.
  struct Boxed {
    TileEntry entry;
    std::int32_t slot;
  };
  // Triangles come in submission order, each perhaps several times in a row.
  std::int32_t slot_of(std::uint32_t triangle) {
    if (triangles_.empty() || triangles_.back() != triangle) triangles_.push_back(triangle);
    return static_cast<std::int32_t>(triangles_.size() - 1);
  }
  // Whether any material of the frame cuts something out: of a frame without, no triangle is asked.
  enum class WithCutOuts { no, yes };
  template <WithCutOuts cut_outs>
  void decide_as(const FrameContext& context, std::size_t index);
  template <WithCutOuts cut_outs>
  void read(const Bins& bins, std::size_t index);
  void sort_boxed();
  template <WithCutOuts cut_outs>
  void draw_boxed(const FrameContext& context);

  bool is_there(const TileEntry& sample);
  DepthTile& alone();
  void add_what_is_there(const PixelRect& pixels, std::int32_t slot);

  DepthTile depths_;
  SnappedRasterizer rasterizer_;
  // Where not all are stored: of triangles drawn together, and of small ones.
  std::array<PlacedVertex, 2 * 3 * SnappedRasterizer::lanes> corners_;
  std::vector<std::uint32_t> triangles_;
  std::vector<Boxed> boxed_, sorted_;
  // Of frames with cut-outs: where their triangles are drawn alone; empty again after each.
  std::unique_ptr<CutOuts> cut_outs_;
  std::unique_ptr<DepthTile> alone_;
  bool alone_is_clear_ = false; // for this tile
  PixelRect tile_;
  std::span<const SamplePosition> samples_;
};

} // namespace refraster
