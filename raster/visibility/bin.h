#pragma once
// Which triangles each tile has to test, in submission order.

#include "raster/frame_context.h"
#include "raster/visibility/setup.h"
#include "raster/visibility/tile_list.h"

#include <cstdint>
#include <vector>

namespace refraster {

/// The pixels of the frame that are rendered, cut into square tiles. Row 0 is the top.
struct TileGrid {
  int x = 0, y = 0, width = 0, height = 0; // pixels of the full image
  int tile_size = 64;

  int columns() const { return (width + tile_size - 1) / tile_size; }
  int rows() const { return (height + tile_size - 1) / tile_size; }
  std::size_t tiles() const { return static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows()); }
  PixelRect tile(std::size_t index) const;
};
TileGrid tile_grid(const FrameInput& input);

/// A triangle that needs projective set-up, with its number in the frame.
struct NumberedProjective {
  std::uint32_t triangle = 0;
  ProjectiveTriangle set_up;
};

struct Bins {
  TileLists lists;
  // Those that may be seen in the image, in order of number, by the runs of triangles that have any: there are few.
  std::vector<std::vector<NumberedProjective>> projective;

  const ProjectiveTriangle& projective_triangle(std::uint32_t number) const;
  /// Null if the triangle needs none, or was dropped, or lies a pixel or more outside the image.
  const ProjectiveTriangle* find_projective(std::uint32_t number) const;
};

/// Drops what cannot be seen (counted by reason in `counts`) and lists the rest by tile, in submission order. A tile's
/// list may hold triangles that cover none of its samples; it misses none that does. Of triangles that are so small
/// that it is quicker to find the samples they cover at once, it holds those samples. Memory: 16 bytes a list entry.
/// `bins` may be those of another frame: their memory is used again.
void bin_triangles(const FrameInput& input, const Geometry& geometry, Bins& bins, FrameCounts& counts);

} // namespace refraster
