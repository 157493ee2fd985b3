#pragma once
// Surfaces of triangles on the lattice, as many at once as a register has lanes: which corner is the anchor, the lines
// and the weights of perspective. Of each the same as by set_up_snapped and perspective_weights, bit for bit.

#include "raster/vertex/snapped_lanes.h"

#include <array>
#include <cstdint>

namespace refraster {

template <int N>
struct AttributeSetupLanes {
  using T = Wide<double, N>;
  using Ints = VectorOf<std::int32_t, N>;
  struct Corner {
    Ints submitted; // which of the triangle's corners it is
    Ints a, b, c;   // the line opposite, c modulo 2^32
    T weight;       // of perspective
  };
  std::array<Corner, 3> corner; // in the order of x and then y
  Ints wraps; // not 0 where the lines' values at pixel centres are less than 2^31: see AttributeSetup::edge
};

/// The corners as submitted, and their 1 / w. Lanes without area, or with corners off the lattice, mean nothing.
template <int N>
AttributeSetupLanes<N> attribute_setup_lanes(const std::array<CornerLanes<N>, 3>& v,
                                             const std::array<Wide<double, N>, 3>& inverse_w) {
  using T = Wide<double, N>;
  using Words = VectorOf<std::uint32_t, N>;
  constexpr std::size_t inverse_of_w = 0, number = 1;
  const auto submitted = [&](std::size_t k) {
    return PlacedCorner<N, 2>{v[k].x, v[k].y, {inverse_w[k], T(static_cast<double>(k))}};
  };
  std::array<PlacedCorner<N, 2>, 3> p{submitted(0), submitted(1), submitted(2)};
  sort_corners(p);

  const T area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
  const T sign = select(area > T(0.0), T(1.0), T(-1.0));
  // At a pixel's centre a line is at most the area, plus what it changes by from a covered sample to the centre, half a
  // pixel away.
  auto wraps = abs(area) <= T(0x1p30);
  AttributeSetupLanes<N> lanes;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto &from = p[(k + 1) % 3], &to = p[(k + 2) % 3];
    const T a = sign * (from.y - to.y), b = sign * (to.x - from.x);
    wraps = wraps & (abs(a) <= T(0x1p21)) & (abs(b) <= T(0x1p21));
    const auto word = [](const T& x) { return reinterpret_cast<Words>(integers<N>(x)); };
    const Words c = -(word(a) * word(from.x) + word(b) * word(from.y));
    lanes.corner[k] = {integers<N>(p[k].with[number]), integers<N>(a), integers<N>(b),
                       reinterpret_cast<VectorOf<std::int32_t, N>>(c), T(0.0)};
  }
  lanes.wraps = integers<N>(select(wraps, T(1.0), T(0.0)));
  // perspective_weights
  const auto inverse = [&](std::size_t k) { return p[k].with[inverse_of_w]; };
  const T nearest = max(inverse(0), max(inverse(1), inverse(2)));
  for (std::size_t k = 0; k < 3; ++k) lanes.corner[k].weight = inverse(k) / nearest;
  return lanes;
}

} // namespace refraster
