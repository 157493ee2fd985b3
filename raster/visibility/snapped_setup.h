#pragma once
// Set-up of triangles on the lattice: one, or as many at once as a register has lanes. Edge functions, areas and sums
// of them are integers under 2^53, and so exact in double; see subpixel.h.

#include "math/lanes/lane_bits.h"
#include "raster/lanes.h"
#include "raster/vertex/transform.h"

#include <array>
#include <utility>

namespace refraster {

/// One corner of each of N triangles.
template <int N>
struct CornerLanes {
  using Ints = VectorOf<std::int32_t, N>;
  VectorOf<std::int32_t, 2 * N> words; // PlacedVertex's two, in turn
  Ints x_subpixel, y_subpixel;
  Wide<double, N> x, y, z; // x and y: the same
};

/// vertex(lane) is the corner of the triangle in that lane.
template <int N, class Vertex>
CornerLanes<N> gather_corners(const Vertex& vertex) {
  static_assert(sizeof(PlacedVertex) == 2 * sizeof(double));
  const std::array<Wide<double, N>, 2> numbers_of = gather_pairs<N>([&](int lane) { return &vertex(lane); });
  CornerLanes<N> corner;
  corner.words = reinterpret_cast<VectorOf<std::int32_t, 2 * N>>(numbers_of[0].v);
  corner.z = numbers_of[1];
  [&]<int... I>(std::integer_sequence<int, I...>) {
    const VectorOf<std::int32_t, 2 * N> places = corner.words >> 6;
    corner.x_subpixel = __builtin_shufflevector(places, places, (2 * I)...);
    corner.y_subpixel = __builtin_shufflevector(places, places, (2 * I + 1)...);
  }
  (std::make_integer_sequence<int, N>{});
  corner.x = numbers<N>(corner.x_subpixel);
  corner.y = numbers<N>(corner.y_subpixel);
  return corner;
}

/// A corner of each triangle in subpixels, and what else goes with it.
template <Lanes T, std::size_t count>
struct SnappedCorner {
  T x, y;
  std::array<T, count> with;
};

/// The corners stand in the order of x, and then y, so that the same triangle submitted with its vertices rotated or
/// reversed is set up alike, bit for bit. Edge function k is opposite corner k and positive inside. With corner 0 as
/// the origin, functions 1 and 2 are a[k] (x - x0) + b[k] (y - y0), and all three add up to `size` everywhere.
template <Lanes T, std::size_t count>
struct SnappedSetup {
  std::array<SnappedCorner<T, count>, 3> corner;
  std::array<T, 3> a, b;
  T size; // twice the area; 0 where the corners are on one line, and then a and b mean nothing

  /// A sample is covered where each edge function is greater than this: the top-left rule, see
  /// EdgeFunction::owns_ties. |b| is less than 2^26.
  std::array<T, 3> thresholds() const {
    const auto threshold = [&](std::size_t k) { return select(a[k] * T(0x1p26) + b[k] > T(0.0), T(-0.5), T(0.0)); };
    return {threshold(0), threshold(1), threshold(2)};
  }
};

template <Lanes T, std::size_t count>
SnappedSetup<T, count> set_up_snapped(SnappedCorner<T, count> p0, SnappedCorner<T, count> p1,
                                      SnappedCorner<T, count> p2) {
  const auto key = [](const SnappedCorner<T, count>& p) { return p.x * T(0x1p26) + p.y; }; // exact
  T key0 = key(p0), key1 = key(p1), key2 = key(p2);
  const auto exchange_if_after = [](T& key_p, SnappedCorner<T, count>& p, T& key_q, SnappedCorner<T, count>& q) {
    const auto after = key_p > key_q;
    const auto exchange = [&](T& of_p, T& of_q) {
      const T first = select(after, of_q, of_p);
      of_q = select(after, of_p, of_q);
      of_p = first;
    };
    exchange(key_p, key_q);
    exchange(p.x, q.x), exchange(p.y, q.y);
    for (std::size_t c = 0; c < count; ++c) exchange(p.with[c], q.with[c]);
  };
  exchange_if_after(key0, p0, key1, p1), exchange_if_after(key1, p1, key2, p2), exchange_if_after(key0, p0, key1, p1);

  const T dx1 = p1.x - p0.x, dy1 = p1.y - p0.y, dx2 = p2.x - p0.x, dy2 = p2.y - p0.y;
  const T area = dx1 * dy2 - dx2 * dy1;
  const T sign = select(area > T(0.0), T(1.0), T(-1.0));
  const T a1 = sign * dy2, b1 = -(sign * dx2), a2 = -(sign * dy1), b2 = sign * dx1;
  return {{p0, p1, p2}, {-(a1 + a2), a1, a2}, {-(b1 + b2), b1, b2}, sign * area};
}

/// Corners with their depths.
template <int N>
SnappedSetup<Wide<double, N>, 1> set_up_snapped(const CornerLanes<N>& v0, const CornerLanes<N>& v1,
                                                const CornerLanes<N>& v2) {
  using Corner = SnappedCorner<Wide<double, N>, 1>;
  return set_up_snapped(Corner{v0.x, v0.y, {v0.z}}, Corner{v1.x, v1.y, {v1.z}}, Corner{v2.x, v2.y, {v2.z}});
}

/// z / w at a sample, from the values there of edge functions 1 and 2: within the range of the corners' depths.
template <Lanes T>
struct DepthPlane {
  T z0, slope1, slope2, z_min, z_max;

  T at(const T& e1, const T& e2) const { return min(max(z0 + e1 * slope1 + e2 * slope2, z_min), z_max); }
};

/// Of triangles with area that were set up with their depths.
template <Lanes T>
DepthPlane<T> depth_plane(const SnappedSetup<T, 1>& t) {
  const T &z0 = t.corner[0].with[0], &z1 = t.corner[1].with[0], &z2 = t.corner[2].with[0];
  return {z0, (z1 - z0) / t.size, (z2 - z0) / t.size, min(z0, min(z1, z2)), max(z0, max(z1, z2))};
}

/// The weights of perspective interpolation, from 1 / w > 0 of the corners: attribute f at a sample = sum of mu_k f_k /
/// sum of mu_k with mu_k = edge function k at the sample times weight[k]. 0 < weight <= 1.
template <class T>
std::array<T, 3> perspective_weights(const std::array<T, 3>& inverse_w) {
  const T nearest = max(inverse_w[0], max(inverse_w[1], inverse_w[2]));
  return {inverse_w[0] / nearest, inverse_w[1] / nearest, inverse_w[2] / nearest};
}

} // namespace refraster
