#pragma once
// Window coordinates as exact integers, and the edge functions of the lines between them.
//
// A window coordinate is counted in subpixels, 256 to a pixel, y down, (0, 0) at the top left corner of the image.
// The centre of pixel (px, py) is the sample (256 px + 128, 256 py + 128). A vertex is snapped to this lattice before
// anything else is computed, so that two triangles that share it see the same point.
//
// Sizes. An image has at most 2^14 pixels a side: samples lie in [0, 2^22]. Snapped vertices lie in the guard band
// [-2^24, 2^24]. The line through two of them has |a|, |b| <= 2^25 and |c| <= 2^50, and its value at a sample is at
// most 2^25 2^22 2 + 2^50 < 2^52: exact in std::int64_t, and exact in double as well, which is what the SIMD lanes use.

#include <cstdint>

namespace refraster {

inline constexpr int subpixels = 256;
inline constexpr int max_image_side = 16384;
inline constexpr std::int32_t guard_band = 1 << 24; // subpixels: 65536 pixels either way

using Int128 = __int128;

/// a x + b y + c over subpixels: positive inside the triangle it bounds. `Coefficient` is exact for what it holds.
template <class Slope, class Value>
struct EdgeFunction {
  Slope a = 0, b = 0;
  Value c = 0;

  Value at(std::int32_t x, std::int32_t y) const { return static_cast<Value>(a) * x + static_cast<Value>(b) * y + c; }
  EdgeFunction operator-() const { return {-a, -b, -c}; }

  /// The top-left rule, y down: a sample exactly on the line belongs to the triangle for which the line is a left edge
  /// (the inside is to the right) or a top edge (level, the inside is below). Of the two triangles at a shared edge,
  /// for which the edge function has opposite signs, this names exactly one.
  bool owns_ties() const { return a > 0 || (a == 0 && b > 0); }

  bool covers(std::int32_t x, std::int32_t y) const {
    const Value value = at(x, y);
    return value > 0 || (value == 0 && owns_ties());
  }

  /// The greatest value over the rectangle [x0, x1] x [y0, y1].
  Value max_over(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1) const {
    return at(a > 0 ? x1 : x0, b > 0 ? y1 : y0);
  }
};

/// Between two snapped vertices.
using SnappedEdge = EdgeFunction<std::int64_t, std::int64_t>;
/// Where at least one end is behind the eye or beyond the guard band: |a|, |b| < 2^61, |c| < 2^110.
using ProjectiveEdge = EdgeFunction<std::int64_t, Int128>;

} // namespace refraster
