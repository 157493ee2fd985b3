#pragma once
// In which order the tiles of a frame are drawn.

#include "raster/visibility/bin.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace refraster {

/// The tiles of a grid, each once. One thread takes them as they lie, since neighbours share vertices. Several begin
/// with those that have most to draw, so that none of these is begun last, when the other threads have nothing left to
/// do: the last thread is then done at most one tile after the first.
std::vector<std::uint32_t> tile_order(const TileGrid& grid, const TileLists& lists, int threads);

} // namespace refraster
