#pragma once
// Triangles of no more than 2 x 2 pixels: which samples they cover, and how deep, found for a register of triangles at
// once. A triangle of a million covers a sample or two; rows of samples would find a register all but empty.

#include "raster/vertex/snapped_lanes.h"
#include "raster/visibility/depth_range.h"

#include <array>

namespace refraster {

/// Of the samples (x, y), (x + 1 pixel, y), (x, y + 1 pixel), (x + 1 pixel, y + 1 pixel):
template <int N>
struct SmallCoverage {
  std::array<std::uint32_t, 4> lanes; // the triangles that cover it, at a depth that is drawn
  std::array<Wide<double, N>, 4> z;
};

/// x, y: a sample of each triangle, subpixels.
template <int N>
SmallCoverage<N> cover_small(const SnappedLanes<N>& t, const Wide<double, N>& x, const Wide<double, N>& y) {
  using T = Wide<double, N>;
  const T dx = x - t.x0, dy = y - t.y0, pixel(double{subpixels});
  const T corner1 = t.a1 * dx + t.b1 * dy, corner2 = t.a2 * dx + t.b2 * dy;
  const T right1 = t.a1 * pixel, right2 = t.a2 * pixel, down1 = t.b1 * pixel, down2 = t.b2 * pixel;
  SmallCoverage<N> result;
  const auto cover = [&](std::size_t i, const T& e1, const T& e2) {
    const T e0 = t.size - e1 - e2;
    // The same operations as SnappedTriangle::depth.
    const T z = min(max(t.z0 + e1 * t.slope1 + e2 * t.slope2, t.z_min), t.z_max);
    result.z[i] = z;
    result.lanes[i] =
        lane_set((e0 > t.least[0]) & (e1 > t.least[1]) & (e2 > t.least[2]) & (z >= T(-1.0)) & (z < T(beyond_far)));
  };
  cover(0, corner1, corner2);
  cover(1, corner1 + right1, corner2 + right2);
  cover(2, corner1 + down1, corner2 + down2);
  cover(3, corner1 + right1 + down1, corner2 + right2 + down2);
  return result;
}

} // namespace refraster
