#pragma once
// Set-up of triangles on the lattice, as many at once as a register has lanes: what set_up_snapped makes of each, bit
// for bit. Lines and areas are integers under 2^53, and so exact in double; see subpixel.h.

#include "raster/lanes.h"
#include "raster/transform.h"

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

/// N triangles as SnappedTriangle describes one. With corner 0 as the origin: line[1].at(x, y) = a1 (x - x0) +
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
  struct Corner {
    T key, x, y, z; // key: in the order of x, and then y
  };
  const auto corner = [](const CornerLanes<N>& v) { return Corner{v.x * T(0x1p26) + v.y, v.x, v.y, v.z}; };
  const auto exchange_if_after = [](Corner& p, Corner& q) {
    const auto after = p.key > q.key;
    const Corner first{minimum(p.key, q.key), select(after, q.x, p.x), select(after, q.y, p.y),
                       select(after, q.z, p.z)};
    q = {maximum(p.key, q.key), select(after, p.x, q.x), select(after, p.y, q.y), select(after, p.z, q.z)};
    p = first;
  };
  Corner p0 = corner(v0), p1 = corner(v1), p2 = corner(v2);
  exchange_if_after(p0, p1), exchange_if_after(p1, p2), exchange_if_after(p0, p1);

  const T dx1 = p1.x - p0.x, dy1 = p1.y - p0.y, dx2 = p2.x - p0.x, dy2 = p2.y - p0.y;
  const T area = dx1 * dy2 - dx2 * dy1;
  const T sign = select(area > T(0.0), T(1.0), T(-1.0));
  SnappedLanes<N> t;
  t.x0 = p0.x, t.y0 = p0.y;
  t.a1 = sign * dy2, t.b1 = -(sign * dx2);
  t.a2 = -(sign * dy1), t.b2 = sign * dx1;
  t.size = sign * area;
  // The top-left rule, see Line::owns_ties; |b| is less than 2^26.
  const auto least = [](const T& a, const T& b) { return select(a * T(0x1p26) + b > T(0.0), T(-0.5), T(0.0)); };
  t.least = {least(t.a0(), t.b0()), least(t.a1, t.b1), least(t.a2, t.b2)};
  t.z0 = p0.z;
  t.slope1 = (p1.z - p0.z) / t.size;
  t.slope2 = (p2.z - p0.z) / t.size;
  t.z_min = minimum(p0.z, minimum(p1.z, p2.z));
  t.z_max = maximum(p0.z, maximum(p1.z, p2.z));
  return t;
}

} // namespace refraster
