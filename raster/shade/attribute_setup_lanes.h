#pragma once
// Attribute set-up of triangles on the lattice, as many at once as a register has lanes: which corner is the anchor,
// the edge functions and the weights of perspective.

#include "raster/visibility/snapped_setup.h"

#include <array>
#include <cstdint>

namespace refraster {

template <int N>
struct AttributeSetupLanes {
  using T = Wide<double, N>;
  using Ints = VectorOf<std::int32_t, N>;
  struct Corner {
    Ints submitted; // which of the triangle's corners it is
    Ints a, b, c;   // the edge function opposite, c modulo 2^32
    T weight;       // of perspective
  };
  std::array<Corner, 3> corner; // in the order of x and then y
  Ints wraps; // not 0 where their values at pixel centres are less than 2^31: see AttributeSetup::edge
};

/// The corners as submitted, and their 1 / w. Lanes without area, or with corners off the lattice, mean nothing.
template <int N>
AttributeSetupLanes<N> attribute_setup_lanes(const std::array<CornerLanes<N>, 3>& v,
                                             const std::array<Wide<double, N>, 3>& inverse_w) {
  using T = Wide<double, N>;
  using Words = VectorOf<std::uint32_t, N>;
  constexpr std::size_t inverse_of_w = 0, number = 1;
  const auto submitted = [&](std::size_t k) {
    return SnappedCorner<T, 2>{v[k].x, v[k].y, {inverse_w[k], T(static_cast<double>(k))}};
  };
  const SnappedSetup<T, 2> t = set_up_snapped(submitted(0), submitted(1), submitted(2));

  // At a pixel's centre an edge function is at most the size, plus what it changes by from a covered sample to the
  // centre, half a pixel away.
  auto wraps = t.size <= T(0x1p30);
  AttributeSetupLanes<N> lanes;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& on_edge = t.corner[(k + 1) % 3];
    wraps = wraps & (abs(t.a[k]) <= T(0x1p21)) & (abs(t.b[k]) <= T(0x1p21));
    const auto word = [](const T& x) { return reinterpret_cast<Words>(integers<N>(x)); };
    const Words c = -(word(t.a[k]) * word(on_edge.x) + word(t.b[k]) * word(on_edge.y));
    lanes.corner[k] = {integers<N>(t.corner[k].with[number]), integers<N>(t.a[k]), integers<N>(t.b[k]),
                       reinterpret_cast<VectorOf<std::int32_t, N>>(c), T(0.0)};
  }
  lanes.wraps = integers<N>(select(wraps, T(1.0), T(0.0)));
  const auto inverse = [&](std::size_t k) { return t.corner[k].with[inverse_of_w]; };
  const std::array<T, 3> weight = perspective_weights<T>({inverse(0), inverse(1), inverse(2)});
  for (std::size_t k = 0; k < 3; ++k) lanes.corner[k].weight = weight[k];
  return lanes;
}

} // namespace refraster
