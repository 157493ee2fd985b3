#pragma once
// A triangle on the lattice set up in whole numbers, one step after the other: what the renderer's set-up, in lanes or
// alone, is held against. Shares no code with it but the types.

#include "raster/visibility/setup.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

namespace refraster::test {

struct ScalarTriangle {
  std::array<std::int64_t, 3> a{}, b{}, c{}; // of the edge function opposite corner k, positive inside
  std::array<std::uint8_t, 3> corner{};      // which submitted vertex stands at each place: by x, then by y
  std::int64_t size = 0;                     // twice the area
  Facing facing = Facing::front;
  double z0 = 0, slope1 = 0, slope2 = 0, z_min = 0, z_max = 0;
  std::int32_t x_min = 0, x_max = 0, y_min = 0, y_max = 0; // bounding box, subpixels

  std::int64_t at(std::size_t k, std::int32_t x, std::int32_t y) const { return a[k] * x + b[k] * y + c[k]; }
  /// z / w there.
  double depth(std::int32_t x, std::int32_t y) const {
    const double z = z0 + static_cast<double>(at(1, x, y)) * slope1 + static_cast<double>(at(2, x, y)) * slope2;
    return std::clamp(z, z_min, z_max);
  }
};

/// Nothing if the triangle has no area.
inline std::optional<ScalarTriangle> set_up_scalar(const std::array<WindowVertex, 3>& v) {
  ScalarTriangle t;
  t.corner = {0, 1, 2};
  std::stable_sort(t.corner.begin(), t.corner.end(), [&](std::uint8_t i, std::uint8_t j) {
    return std::pair(v[i].x, v[i].y) < std::pair(v[j].x, v[j].y);
  });
  const auto turn = [](const WindowVertex& p, const WindowVertex& q, const WindowVertex& r) { // y down: < 0 is front
    return std::int64_t{q.x - p.x} * (r.y - p.y) - std::int64_t{r.x - p.x} * (q.y - p.y);
  };
  const WindowVertex &p0 = v[t.corner[0]], &p1 = v[t.corner[1]], &p2 = v[t.corner[2]];
  const std::int64_t area = turn(p0, p1, p2);
  if (area == 0) return std::nullopt;
  t.size = std::abs(area);
  t.facing = turn(v[0], v[1], v[2]) < 0 ? Facing::front : Facing::back;
  for (std::size_t k = 0; k < 3; ++k) {
    const WindowVertex &p = v[t.corner[(k + 1) % 3]], &q = v[t.corner[(k + 2) % 3]];
    const std::int64_t sign = area > 0 ? 1 : -1;
    t.a[k] = sign * (p.y - q.y), t.b[k] = sign * (q.x - p.x);
    t.c[k] = -(t.a[k] * p.x + t.b[k] * p.y);
  }
  t.z0 = p0.z, t.slope1 = (p1.z - p0.z) / static_cast<double>(t.size);
  t.slope2 = (p2.z - p0.z) / static_cast<double>(t.size);
  t.z_min = std::min({p0.z, p1.z, p2.z}), t.z_max = std::max({p0.z, p1.z, p2.z});
  t.x_min = p0.x, t.x_max = p2.x;
  t.y_min = std::min({p0.y, p1.y, p2.y}), t.y_max = std::max({p0.y, p1.y, p2.y});
  return t;
}

} // namespace refraster::test
