#pragma once
// Triangles of no more than 2 x 2 pixels: which samples they cover, and how deep, found for a register of triangles at
// once. A triangle of a million covers a sample or two; rows of samples would find a register all but empty.

#include "raster/visibility/depth_range.h"
#include "raster/visibility/snapped_setup.h"

#include <array>

namespace refraster {

/// Whether samples lie in triangles, at a depth that is drawn: by the values there of edge functions 1 and 2.
template <int N>
class SampleTest {
public:
  using T = Wide<double, N>;
  explicit SampleTest(const SnappedSetup<T, 1>& t)
      : size_(t.size), threshold_(t.thresholds()), depth_(depth_plane(t)) {}

  /// The triangles that do, and their depths at it.
  std::uint32_t covering(const T& e1, const T& e2, T& z) const {
    const T e0 = size_ - e1 - e2;
    z = depth_.at(e1, e2);
    return lane_set((e0 > threshold_[0]) & (e1 > threshold_[1]) & (e2 > threshold_[2]) & (z >= T(-1.0)) &
                    (z < T(beyond_far)));
  }

private:
  T size_;
  std::array<T, 3> threshold_;
  DepthPlane<T> depth_;
};

/// Of the samples (x, y), (x + 1 pixel, y), (x, y + 1 pixel), (x + 1 pixel, y + 1 pixel):
template <int N>
struct SmallCoverage {
  std::array<std::uint32_t, 4> lanes; // the triangles that cover it, at a depth that is drawn
  std::array<Wide<double, N>, 4> z;
};

/// x, y: a sample of each triangle, subpixels.
template <int N>
SmallCoverage<N> cover_small(const SnappedSetup<Wide<double, N>, 1>& t, const Wide<double, N>& x,
                             const Wide<double, N>& y) {
  using T = Wide<double, N>;
  const SampleTest<N> test(t);
  const T dx = x - t.corner[0].x, dy = y - t.corner[0].y, pixel(double{subpixels});
  const T corner1 = t.a[1] * dx + t.b[1] * dy, corner2 = t.a[2] * dx + t.b[2] * dy;
  const T right1 = t.a[1] * pixel, right2 = t.a[2] * pixel, down1 = t.b[1] * pixel, down2 = t.b[2] * pixel;
  SmallCoverage<N> result;
  const auto cover = [&](std::size_t i, const T& e1, const T& e2) {
    result.lanes[i] = test.covering(e1, e2, result.z[i]);
  };
  cover(0, corner1, corner2);
  cover(1, corner1 + right1, corner2 + right2);
  cover(2, corner1 + down1, corner2 + down2);
  cover(3, corner1 + right1 + down1, corner2 + right2 + down2);
  return result;
}

} // namespace refraster
