#pragma once
// From clip coordinates to the window, for as many vertices as T has lanes.

#include "math/lanes/lane_bits.h"
#include "math/vec.h"
#include "raster/vertex/subpixel.h"

#include <limits>

namespace refraster {

/// The products as GLM adds them up, which the bits of every image depend on.
template <class T>
T homogeneous(const Double4x4& m, int row, const Vec3<T>& p) {
  const auto times = [&](int column) { return T(m[column][row]) * p[column]; };
  return (times(0) + times(1)) + (times(2) + T(m[3][row]));
}
template <class T>
T linear(const Double3x3& m, int row, const Vec3<T>& p) {
  const auto times = [&](int column) { return T(m[column][row]) * p[column]; };
  return times(0) + times(1) + times(2);
}

/// A vertex of the mesh in the world: its position, which no difference of two overflows.
template <class T>
Vec3<T> world_position(const Double4x4& world_from_object, const Vec3<T>& p) {
  const T far(0x1p1022);
  const auto component = [&](int row) { return min(max(homogeneous(world_from_object, row, p), -far), far); };
  return {component(0), component(1), component(2)};
}
/// And its normal, of any length.
template <class T>
Vec3<T> world_normal(const Double3x3& world_from_normal, const Vec3<T>& n) {
  const auto component = [&](int row) { return linear(world_from_normal, row, n); };
  return {component(0), component(1), component(2)};
}

/// What becomes of vertices in the window. All but z and inverse_w are whole numbers.
template <Lanes T>
struct WindowLanes {
  T x, y;         // subpixels; 0 if not on the lattice
  T z, inverse_w; // z / w and 1 / w; 0 if not on the lattice
  T sides;      // the clip half-spaces that the vertex lies outside of: 1 2 left right, 4 8 bottom top, 16 32 near far
  T not_finite; // 1 where a clip coordinate is NaN or infinite: then sides is 0
  T unsnapped;  // 1 where all are finite, but w <= 0 or the vertex lies beyond the guard band
};

/// |x| < 2^51 rounded to a whole number, half to even as IEEE 754 adds, and as Direct3D 11.3 §3.4.1 snaps. Its lowest
/// 32 bits, before the bias is taken off again, are that number in two's complement.
inline constexpr double rounding_bias = 0x1.8p52;
template <Lanes T>
T nearest_whole(const T& x) {
  return x + T(rounding_bias) - T(rounding_bias);
}
template <Lanes T>
LaneBits<T> whole_bits(const T& x) {
  return bits_of(x + T(rounding_bias));
}

template <Lanes T>
WindowLanes<T> window_lanes(const Vec4<T>& clip, int width, int height) {
  const auto finite = [](const T& c) { return abs(c) <= T(std::numeric_limits<double>::max()); };
  const auto one_where = [](auto m, double one) { return select(m, T(one), T(0.0)); };
  const T &w = clip.w, behind = -w;
  const auto x_ok = finite(clip.x), y_ok = finite(clip.y), z_ok = finite(clip.z), w_ok = finite(w);
  const auto ok = x_ok & y_ok & z_ok & w_ok;
  const T sides = one_where(clip.x < behind, 1) + one_where(clip.x > w, 2) + one_where(clip.y < behind, 4) +
                  one_where(clip.y > w, 8) + one_where(clip.z < behind, 16) + one_where(clip.z > w, 32);

  const T half_width(subpixels / 2.0 * width), half_height(subpixels / 2.0 * height);
  const T x = clip.x / w * half_width + half_width;
  const T y = half_height - clip.y / w * half_height;
  // Below the smallest normal number 1 / w would overflow: such a vertex is as good as on the eye plane.
  const auto snapped = ok & (w >= T(std::numeric_limits<double>::min())) & (abs(x) <= T(double{guard_band})) &
                       (abs(y) <= T(double{guard_band}));
  const auto if_snapped = [&](const T& value) { return select(snapped, value, T(0.0)); };
  return {if_snapped(nearest_whole(x)), if_snapped(nearest_whole(y)), if_snapped(clip.z / w),
          if_snapped(T(1.0) / w),       select(ok, sides, T(0.0)),    one_where(!ok, 1),
          one_where(ok & !snapped, 1)};
}

} // namespace refraster
