#pragma once
// Set-up of triangles on the lattice, as many at once as a register has lanes: what set_up_snapped makes of each, bit
// for bit. Lines and areas are integers under 2^53, and so exact in double; see subpixel.h.

#include "raster/lanes.h"
#include "raster/vertex/transform.h"

#include <cstring>
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
  using Pair = Wide<double, 2>;
  static_assert(sizeof(PlacedVertex) == sizeof(Pair));
  const auto load = [&](int lane) { return load_lanes<Pair>(&vertex(lane)); };
  // Lanes 0, 2, 4 … and 1, 3, 5 … side by side: one interleaving parts words from depths, and leaves lanes in order.
  const auto every_second = [&](int first) {
    if constexpr (N == 2) return load(first);
    else if constexpr (N == 4) return joined(load(first), load(first + 2));
    else return joined(joined(load(first), load(first + 2)), joined(load(first + 4), load(first + 6)));
  };
  static_assert(N <= 8);
  const Wide<double, N> even = every_second(0), odd = every_second(1);
  CornerLanes<N> corner;
  [&]<int... I>(std::integer_sequence<int, I...>) {
    const auto words = __builtin_shufflevector(even.v, odd.v, (I % 2 * N + I / 2 * 2)...);
    corner.words = reinterpret_cast<VectorOf<std::int32_t, 2 * N>>(words);
    corner.z = __builtin_shufflevector(even.v, odd.v, (I % 2 * N + I / 2 * 2 + 1)...);
    const VectorOf<std::int32_t, 2 * N> places = corner.words >> 6;
    corner.x_subpixel = __builtin_shufflevector(places, places, (2 * I)...);
    corner.y_subpixel = __builtin_shufflevector(places, places, (2 * I + 1)...);
  }
  (std::make_integer_sequence<int, N>{});
  corner.x = numbers<N>(corner.x_subpixel);
  corner.y = numbers<N>(corner.y_subpixel);
  return corner;
}

/// A corner on the lattice, with what else is to go with it.
template <int N, std::size_t count>
struct PlacedCorner {
  Wide<double, N> x, y;
  std::array<Wide<double, N>, count> with;
};

/// Puts three corners into the order of x, and then y, in each lane: that of set_up_snapped.
template <int N, std::size_t count>
void sort_corners(std::array<PlacedCorner<N, count>, 3>& corner) {
  using T = Wide<double, N>;
  const auto key = [&](std::size_t k) { return corner[k].x * T(0x1p26) + corner[k].y; }; // exact
  std::array<T, 3> keys{key(0), key(1), key(2)};
  const auto exchange_if_after = [&](std::size_t i, std::size_t j) {
    const auto after = keys[i] > keys[j];
    const auto exchange = [&](T& p, T& q) {
      const T first = select(after, q, p);
      q = select(after, p, q);
      p = first;
    };
    exchange(keys[i], keys[j]);
    exchange(corner[i].x, corner[j].x), exchange(corner[i].y, corner[j].y);
    for (std::size_t c = 0; c < count; ++c) exchange(corner[i].with[c], corner[j].with[c]);
  };
  exchange_if_after(0, 1), exchange_if_after(1, 2), exchange_if_after(0, 1);
}

/// N triangles as SnappedTriangle describes one. With corner 0 as the origin: edge[1].at(x, y) = a1 (x - x0) +
/// b1 (y - y0), line[2] likewise, and the three lines add up to `size`, twice the area, everywhere.
template <int N>
struct SnappedLanes {
  using T = Wide<double, N>;
  T x0, y0, a1, b1, a2, b2, size;
  std::array<T, 3> least; // a sample is covered where each line's value is greater
  T z0, slope1, slope2, z_min, z_max;

  T a0() const { return -(a1 + a2); }
  T b0() const { return -(b1 + b2); }
};

/// All must have area.
template <int N>
SnappedLanes<N> set_up_lanes(const CornerLanes<N>& v0, const CornerLanes<N>& v1, const CornerLanes<N>& v2) {
  using T = Wide<double, N>;
  const auto corner = [](const CornerLanes<N>& v) { return PlacedCorner<N, 1>{v.x, v.y, {v.z}}; };
  std::array<PlacedCorner<N, 1>, 3> sorted{corner(v0), corner(v1), corner(v2)};
  sort_corners(sorted);
  const auto& [p0, p1, p2] = sorted;
  const auto z = [&](std::size_t k) { return sorted[k].with[0]; };

  const T dx1 = p1.x - p0.x, dy1 = p1.y - p0.y, dx2 = p2.x - p0.x, dy2 = p2.y - p0.y;
  const T area = dx1 * dy2 - dx2 * dy1;
  const T sign = select(area > T(0.0), T(1.0), T(-1.0));
  SnappedLanes<N> t;
  t.x0 = p0.x, t.y0 = p0.y;
  t.a1 = sign * dy2, t.b1 = -(sign * dx2);
  t.a2 = -(sign * dy1), t.b2 = sign * dx1;
  t.size = sign * area;
  // The top-left rule, see EdgeFunction::owns_ties; |b| is less than 2^26.
  const auto least = [](const T& a, const T& b) { return select(a * T(0x1p26) + b > T(0.0), T(-0.5), T(0.0)); };
  t.least = {least(t.a0(), t.b0()), least(t.a1, t.b1), least(t.a2, t.b2)};
  t.z0 = z(0);
  t.slope1 = (z(1) - z(0)) / t.size;
  t.slope2 = (z(2) - z(0)) / t.size;
  t.z_min = min(z(0), min(z(1), z(2)));
  t.z_max = max(z(0), max(z(1), z(2)));
  return t;
}

} // namespace refraster
