#pragma once
// Gaps in a grid, filled from what is around them.

#include <array>
#include <cstddef>
#include <vector>

namespace refraster {

/// Values of three channels on a grid whose last axis goes round; those with weight 0 are not known.
struct GapGrid {
  std::array<std::size_t, 3> size{}; // of the axes, the last one runs fastest
  std::vector<double> values;        // three for each point
  std::vector<double> weights;       // 0 or 1 for each point; in coarser grids from 0 to 1

  std::size_t points() const { return size[0] * size[1] * size[2]; }
};

/// Gives every point a value: known ones keep theirs; the others have what coarser and coarser grids say, of which each
/// point is the mean of what is known in two points of the finer one on each axis, interpolated between them. Gortler,
/// Grzeszczuk, Szeliski, Cohen, "The lumigraph", 1996, section 3.4. Nothing is known: all 0.
void fill_gaps(GapGrid& grid);

} // namespace refraster
