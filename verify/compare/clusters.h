#pragma once
// Where the pixels that differ lie together: one wrong triangle is one cluster, not a thousand pixels.

#include <refraster/compare.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace refraster {

/// All clusters of the pixels that are marked (not 0). The one with most pixels comes first, then row by row. Both
/// images have 1 channel and the same size.
std::vector<Cluster> clusters_of(const Image<std::uint8_t>& marked, const Image<double>& differences);

/// Those of pixels whose difference is above the limit; infinity is above any.
std::vector<Cluster> clusters_over(const Image<double>& differences, double limit);

/// The pixels (x, y) of a cluster of these marks, which holds its worst pixel, in no order that means anything.
std::vector<std::pair<int, int>> cluster_pixels(const Image<std::uint8_t>& marked, const Cluster& cluster);

} // namespace refraster
