#pragma once
// Whether a point lies in a triangle: for tests that judge coverage by themselves.

#include "verify/bounds/window_triangle.h"

#include <cmath>

namespace refraster {

/// Where a point lies when each edge may be moved by so many pixels in x and in y.
enum class Where { inside, on_edge, outside };

inline Where where(const WindowTriangle& triangle, double x, double y, double moved) {
  if (triangle.is_flat()) return Where::outside;
  const std::array<double, 3> value = triangle.at(x, y);
  Where result = Where::inside;
  for (std::size_t i = 0; i < 3; ++i) {
    const double reach = moved * (std::abs(triangle.l[i].x) + std::abs(triangle.l[i].y));
    if (value[i] < -reach) return Where::outside;
    if (value[i] <= reach) result = Where::on_edge;
  }
  return result;
}

} // namespace refraster
