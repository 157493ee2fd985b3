#pragma once
// What a tile sees, as runs of neighbouring pixels: the work list of shading.

#include "raster/visibility/visibility.h"

#include <cstdint>
#include <vector>

namespace refraster {

/// Neighbouring pixels of one row that see one triangle with the same number of samples. Each pixel of a run is one
/// fragment: it is shaded once.
struct FragmentRun {
  std::int32_t slot = 0; // of the triangle, in the tile's list; then of its attribute set-up, in TileAttributes
  std::uint32_t first_fragment = 0; // the run's fragments have consecutive numbers
  std::uint8_t x = 0, y = 0;        // leftmost pixel, counted from the tile's corner
  std::uint8_t length = 1;          // pixels
  std::uint8_t samples = 1;         // of each pixel that see the triangle
};

/// The tile's fragments in row order, and within a pixel in the order of its samples. A run of several pixels has all
/// their samples: a pixel that sees several triangles, or the background beside one, has a run for each triangle, one
/// pixel long.
void list_runs(const TileVisibility& visibility, const PixelRect& tile, int samples, std::vector<FragmentRun>& runs);

} // namespace refraster
