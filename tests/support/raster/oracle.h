#pragma once
// Who owns a sample, found without edge functions and without a tie rule: the sample is moved by (e, e^2) with e
// smaller than anything the lattice can resolve, so that it never lies on an edge, and a ray from it counts the edges
// it crosses. Moving right by e gives a tie to the triangle on the right of a left edge; moving down by e^2 gives it to
// the triangle below a top edge: this is what the top-left rule means.

#include <array>
#include <cstdint>

namespace refraster::test {

struct LatticePoint {
  std::int64_t x, y;
};

/// Exact for coordinates under 2^bits, 4 * bits + 8 <= width of Wide's integers. Wide: a signed integer type.
template <class Wide, int bits>
bool oracle_covers(const std::array<LatticePoint, 3>& corners, LatticePoint sample) {
  // One lattice step is 2^(2 (bits + 2)) fine steps; e is 2^(bits + 2) of them, e^2 is one. An edge's direction has
  // components under 2^(bits + 1), so e times a slope is always less than a step, and e^2 less than e.
  constexpr int fine = 2 * (bits + 2);
  const auto refined = [&](std::int64_t v) { return Wide(v) * (Wide(1) << fine); };
  const Wide sx = refined(sample.x) + (Wide(1) << (bits + 2)), sy = refined(sample.y) + 1;
  bool inside = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const LatticePoint &p = corners[i], &q = corners[(i + 1) % 3];
    const bool p_below = refined(p.y) > sy, q_below = refined(q.y) > sy;
    if (p_below == q_below) continue; // the level line through the sample misses this edge
    // The edge crosses it at x = p.x + (sy - p.y) (q.x - p.x) / (q.y - p.y). Is that to the right of the sample?
    const Wide dy = Wide(q.y - p.y);
    const Wide crossing = (refined(p.x) - sx) * dy + (sy - refined(p.y)) * Wide(q.x - p.x);
    if ((crossing > 0) == (dy > 0)) inside = !inside;
  }
  return inside;
}

} // namespace refraster::test
