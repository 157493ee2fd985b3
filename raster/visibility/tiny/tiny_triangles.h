#pragma once
// Triangles of a few pixels in 32-bit integers, twice as many at once as a register holds doubles: where they lie,
// which samples of 2 x 2 pixels they cover, and how deep. Only the depth is a double: the same, bit for bit, as that of
// raster/visibility/snapped_setup.h.
//
// Sizes. Corners lie within 2^14 subpixels of each other, 64 pixels, and the samples within 2^10 of their box: edge
// functions are at most 2^14 2^15 2 = 2^30.

#include "raster/visibility/depth_range.h"
#include "raster/visibility/snapped_setup.h"

#include <array>
#include <bit>
#include <cstdint>
#include <utility>

namespace refraster {

/// Where N triangles lie, as they are submitted.
template <int N>
struct TinyTriangles {
  using Ints = VectorOf<std::int32_t, N>;
  static constexpr std::int32_t max_extent = (1 << 14) - 1; // subpixels

  Ints x[3], y[3];                 // of the corners, subpixels
  Ints x_min, x_max, y_min, y_max; // of the triangles
  bool fit;                        // all have all corners on the lattice, and no triangle is too large

  /// From the two words of PlacedVertex of each corner.
  TinyTriangles(const Ints (&x_sides)[3], const Ints (&y_state)[3]) {
    for (std::size_t k = 0; k < 3; ++k) x[k] = x_sides[k] >> 6, y[k] = y_state[k] >> 6;
    x_min = lesser(x[0], lesser(x[1], x[2])), x_max = greater(x[0], greater(x[1], x[2]));
    y_min = lesser(y[0], lesser(y[1], y[2])), y_max = greater(y[0], greater(y[1], y[2]));
    const Ints room = max_extent - greater(x_max - x_min, y_max - y_min);
    const Ints state = (y_state[0] | y_state[1] | y_state[2]) & 3; // other than 0 it becomes the sign
    fit = negative_lanes(room | -state) == 0;
  }

  /// Twice the area, > 0 if seen from behind.
  Ints area() const { return (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]); }
};

/// The same set up: see SnappedSetup. Of triangles without area it means nothing.
template <int N>
struct TinySetup {
  using Ints = VectorOf<std::int32_t, N>;
  using Unsigned = VectorOf<std::uint32_t, N>;
  Ints submitted[3]; // which of the submitted corners each is
  Ints x0, y0;       // of corner 0
  Ints a[3], b[3], size;

  explicit TinySetup(const TinyTriangles<N>& t) {
    // The corners in the order of x, and then y: 14 bits each from the corner of the box, and which it is.
    const auto key = [&](std::size_t k) {
      return (t.x[k] - t.x_min) << 16 | (t.y[k] - t.y_min) << 2 | static_cast<std::int32_t>(k);
    };
    const Ints k0 = key(0), k1 = key(1), k2 = key(2);
    const Ints lesser01 = lesser(k0, k1), greater01 = greater(k0, k1);
    const Ints s0 = lesser(lesser01, k2), s1 = greater(lesser01, lesser(greater01, k2)), s2 = greater(greater01, k2);
    submitted[0] = s0 & 3, submitted[1] = s1 & 3, submitted[2] = s2 & 3;
    const auto x_of = [](const Ints& sorted) { return sorted >> 16; };
    const auto y_of = [](const Ints& sorted) { return sorted >> 2 & 0x3fff; };
    x0 = t.x_min + x_of(s0), y0 = t.y_min + y_of(s0);
    const Ints dx1 = x_of(s1) - x_of(s0), dy1 = y_of(s1) - y_of(s0);
    const Ints dx2 = x_of(s2) - x_of(s0), dy2 = y_of(s2) - y_of(s0);
    const Ints area = dx1 * dy2 - dx2 * dy1, turned = area >> 31;
    const auto times_sign = [&](const Ints& value) { return (value ^ turned) - turned; };
    size = times_sign(area);
    a[1] = times_sign(dy2), b[1] = times_sign(-dx2), a[2] = times_sign(-dy1), b[2] = times_sign(dx1);
    a[0] = -(a[1] + a[2]), b[0] = -(b[1] + b[2]);
  }

  /// The edge functions at (x, y), subpixels; modulo 2^32 where that is too far from the triangle.
  void values(const Ints& x, const Ints& y, Unsigned (&e)[3]) const {
    const Unsigned dx = as_unsigned(x) - as_unsigned(x0), dy = as_unsigned(y) - as_unsigned(y0);
    for (std::size_t k = 1; k < 3; ++k) e[k] = as_unsigned(a[k]) * dx + as_unsigned(b[k]) * dy;
    e[0] = as_unsigned(size) - e[1] - e[2];
  }
  static Unsigned as_unsigned(const Ints& x) { return std::bit_cast<Unsigned>(x); }
};

/// Of the samples (x, y), (x + 1 pixel, y), (x, y + 1 pixel), (x + 1 pixel, y + 1 pixel):
template <int N>
struct TinyCoverage {
  std::array<std::uint32_t, 4> lanes; // the triangles that cover it, at a depth that is drawn
  std::array<std::array<Wide<double, N / 2>, 2>, 4> z;
};

/// x, y: a sample of each triangle, subpixels; z: depths of the corners as submitted, in two halves. Of triangles
/// without area, or too far from the sample, the result means nothing.
template <int N>
TinyCoverage<N> cover_tiny(const TinyTriangles<N>& triangles,
                           const std::array<std::array<Wide<double, N / 2>, 2>, 3>& z,
                           const VectorOf<std::int32_t, N>& x, const VectorOf<std::int32_t, N>& y) {
  using Ints = VectorOf<std::int32_t, N>;
  constexpr int half = N / 2;
  using Doubles = Wide<double, half>;
  const TinySetup<N> t(triangles);
  typename TinySetup<N>::Unsigned corner[3];
  t.values(x, y, corner);
  // -1 where a sample on the edge is not covered, else 0: see EdgeFunction::owns_ties.
  const auto tie = [&](std::size_t k) { return ~(-((t.a[k] << 15) + t.b[k]) >> 31); };
  const Ints ties[] = {tie(0), tie(1), tie(2)};

  // The depths, by halves.
  std::array<DepthPlane<Doubles>, 2> plane;
  const auto part = [](const Ints& all, int h) {
    return [&]<int... I>(std::integer_sequence<int, I...>) {
      const auto low = __builtin_shufflevector(all, all, I...), high = __builtin_shufflevector(all, all, (half + I)...);
      return numbers<half>(h == 0 ? low : high);
    }
    (std::make_integer_sequence<int, half>{});
  };
  for (int h = 0; h < 2; ++h) {
    const auto at = static_cast<std::size_t>(h);
    const auto z_of = [&](std::size_t k) {
      const Doubles submitted = part(t.submitted[k], h);
      return select(submitted == Doubles(0.0), z[0][at], select(submitted == Doubles(1.0), z[1][at], z[2][at]));
    };
    SnappedSetup<Doubles, 1> set_up;
    for (std::size_t k = 0; k < 3; ++k) set_up.corner[k].with[0] = z_of(k);
    set_up.size = part(t.size, h);
    plane[at] = depth_plane(set_up);
  }

  TinyCoverage<N> result;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto edge = [&](std::size_t k) {
      const auto right = i & 1 ? corner[k] + (t.as_unsigned(t.a[k]) << 8) : corner[k];
      return std::bit_cast<Ints>(i & 2 ? right + (t.as_unsigned(t.b[k]) << 8) : right);
    };
    const Ints e[] = {edge(0), edge(1), edge(2)};
    const auto with_tie = [&](std::size_t k) { return t.as_unsigned(e[k]) + t.as_unsigned(ties[k]); };
    const auto beside = std::bit_cast<Ints>(with_tie(0) | with_tie(1) | with_tie(2));
    std::uint32_t drawn = 0;
    for (int h = 0; h < 2; ++h) {
      const auto at = static_cast<std::size_t>(h);
      const Doubles depth = plane[at].at(part(e[1], h), part(e[2], h));
      result.z[i][at] = depth;
      drawn |= lane_set((depth >= Doubles(-1.0)) & (depth < Doubles(beyond_far))) << (h * half);
    }
    result.lanes[i] = drawn & ~negative_lanes(beside);
  }
  return result;
}

} // namespace refraster
