#pragma once
// Which triangles each tile has to look at, in submission order.

#include "raster/render.h"
#include "raster/samples.h"
#include "raster/setup.h"

#include <cstdint>
#include <span>
#include <vector>

namespace refraster {

/// The pixels of the frame that are rendered, cut into square tiles. Row 0 is the top.
struct TileGrid {
  int x = 0, y = 0, width = 0, height = 0; // pixels of the full image
  int tile_size = 64;

  int columns() const { return (width + tile_size - 1) / tile_size; }
  int rows() const { return (height + tile_size - 1) / tile_size; }
  std::size_t tiles() const { return static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows()); }
  Crop tile(std::size_t index) const;
};

/// A triangle that needs projective set-up, with its number in the frame.
struct NumberedProjective {
  std::uint32_t triangle = 0;
  ProjectiveTriangle set_up;
};

struct Bins {
  std::vector<std::uint64_t> first;           // tiles + 1 entries
  Buffer<std::uint32_t> triangles;            // numbers in the frame; those of tile t are [first[t], first[t + 1])
  std::vector<NumberedProjective> projective; // in order of number: there are few

  std::span<const std::uint32_t> of(std::size_t tile) const {
    return {triangles.data() + first[tile], triangles.data() + first[tile + 1]};
  }
  const ProjectiveTriangle& projective_triangle(std::uint32_t number) const;
};

/// Drops what cannot be seen (counted by reason in `counts`) and lists the rest by tile. A tile's list may hold
/// triangles that cover none of its samples; it misses none that does. Memory: 8 bytes a triangle, 4 a list entry.
/// `bins` may be those of another frame: their memory is used again.
void bin_triangles(const Scene& scene, const Geometry& geometry, const TileGrid& grid, int image_width,
                   int image_height, std::span<const SamplePlace> samples, int threads, Bins& bins,
                   FrameCounts& counts);

} // namespace refraster
