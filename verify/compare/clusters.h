#pragma once
// Where the pixels that differ lie together: one wrong triangle is one cluster, not a thousand pixels.

#include <refraster/image.h>

#include <cstdint>
#include <vector>

namespace refraster {

/// Pixels that touch each other, corners included, and the smallest rectangle around them.
struct Cluster {
  int x = 0, y = 0, width = 0, height = 0;
  std::uint64_t pixels = 0;
  double largest = 0;           // difference in it
  int worst_x = 0, worst_y = 0; // where that is: the first one, row by row
};

/// All clusters of the pixels that are marked (not 0). The one with most pixels comes first, then row by row. Both
/// images have 1 channel and the same size.
std::vector<Cluster> clusters_of(const Image<std::uint8_t>& marked, const Image<double>& differences);

/// Those of pixels whose difference is above the limit; infinity is above any.
std::vector<Cluster> clusters_over(const Image<double>& differences, double limit);

} // namespace refraster
