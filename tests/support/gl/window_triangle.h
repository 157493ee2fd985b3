#pragma once
// A triangle as both renderers see it, in double: for judging what they may make of it.

#include "raster/vertex/transform.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace refraster {

/// In homogeneous window coordinates (x w, y w, w), x to the right and y down in pixels. A corner may lie behind the
/// eye. Over the window, l[i].(x, y, 1) is the perspective-correct weight of corner i, divided by the w of the surface
/// there:
///     1 / w = sum l[i],     f / w = sum l[i] f[i],     z_ndc = sum l[i] z_clip[i].
struct WindowTriangle {
  std::array<Double3, 3> l;
  bool flat = false; // no area: it has no weights

  explicit WindowTriangle(const std::array<Double3, 3>& corner) {
    for (std::size_t i = 0; i < 3; ++i) l[i] = cross(corner[(i + 1) % 3], corner[(i + 2) % 3]);
    const double determinant = dot(corner[0], l[0]);
    flat = determinant == 0;
    for (Double3& line : l) line /= determinant;
  }

  std::array<double, 3> at(double x, double y) const {
    const auto value = [&](const Double3& line) { return line.x * x + line.y * y + line.z; };
    return {value(l[0]), value(l[1]), value(l[2])};
  }
};

/// Where a point lies when each edge may be moved by so many pixels in x and in y.
enum class Where { inside, on_edge, outside };

inline Where where(const WindowTriangle& triangle, double x, double y, double moved) {
  if (triangle.flat) return Where::outside;
  const std::array<double, 3> value = triangle.at(x, y);
  Where result = Where::inside;
  for (std::size_t i = 0; i < 3; ++i) {
    const double reach = moved * (std::abs(triangle.l[i].x) + std::abs(triangle.l[i].y));
    if (value[i] < -reach) return Where::outside;
    if (value[i] <= reach) result = Where::on_edge;
  }
  return result;
}

/// Distance in pixels to the nearest edge's line.
inline double edge_distance(const WindowTriangle& triangle, double x, double y) {
  const std::array<double, 3> value = triangle.at(x, y);
  double least = 1e300;
  for (std::size_t i = 0; i < 3; ++i)
    least = std::min(least, std::abs(value[i]) / std::hypot(triangle.l[i].x, triangle.l[i].y));
  return least;
}

} // namespace refraster
