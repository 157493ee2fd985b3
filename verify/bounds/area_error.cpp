#include "verify/bounds/area_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace refraster {
namespace {

double cross(const Double2& e, const Double2& f) {
  return e.x * f.y - e.y * f.x;
}

/// Each product is rounded, and so are its two factors: the sides from a corner, whichever it is.
double of_triangle(const std::array<Double2, 3>& corners) {
  constexpr double product_roundings = 3 * 0x1p-24;
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Double2 e = corners[(i + 1) % 3] - corners[i], f = corners[(i + 2) % 3] - corners[i];
    const double area = std::abs(cross(e, f)), products = std::abs(e.x * f.y) + std::abs(e.y * f.x);
    if (!(area > 0)) return std::numeric_limits<double>::infinity();
    most = std::max(most, product_roundings * (products / area - 1));
  }
  return most;
}

/// Whether the point lies in the triangle, or no farther from it than the margin along each axis.
bool may_hold(const std::array<Double2, 3>& corners, const Double2& point, double margin) {
  const double sign = cross(corners[1] - corners[0], corners[2] - corners[0]) < 0 ? -1 : 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const Double2 edge = corners[(i + 1) % 3] - corners[i];
    if (sign * cross(edge, point - corners[i]) < -margin * (std::abs(edge.x) + std::abs(edge.y))) return false;
  }
  return true;
}

/// What of a convex polygon has a coordinate of at least a limit, or with side -1 at most (Sutherland, Hodgman,
/// "Reentrant polygon clipping", 1974).
std::vector<Double2> cut(const std::vector<Double2>& polygon, int axis, double limit, double side) {
  std::vector<Double2> left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Double2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double from = side * (a[axis] - limit), to = side * (b[axis] - limit);
    if (from >= 0) left.push_back(a);
    if ((from > 0 && to < 0) || (from < 0 && to > 0)) left.push_back(a + (b - a) * (from / (from - to)));
  }
  return left;
}

} // namespace

AreaError::AreaError(const std::array<Double2, 3>& corners, double width, double height)
    : whole_(of_triangle(corners)) {
  const auto is_in_view = [&](const Double2& at) { return at.x >= 0 && at.x <= width && at.y >= 0 && at.y <= height; };
  if (std::all_of(corners.begin(), corners.end(), is_in_view)) return;
  in_view_.assign(corners.begin(), corners.end());
  in_view_ = cut(cut(in_view_, 0, 0, 1), 0, width, -1);
  in_view_ = cut(cut(in_view_, 1, 0, 1), 1, height, -1);
}

double AreaError::at(const Double2& point, double margin) const {
  double most = whole_;
  const std::size_t size = in_view_.size();
  for (std::size_t first = 0; first < size; ++first)
    for (std::size_t i = 1; i + 1 < size; ++i) {
      const std::array<Double2, 3> piece{in_view_[first], in_view_[(first + i) % size],
                                         in_view_[(first + i + 1) % size]};
      if (may_hold(piece, point, margin)) most = std::max(most, of_triangle(piece));
    }
  return most;
}

} // namespace refraster
