#pragma once
// What single precision makes of the area of a needle.

#include "math/vec.h"

#include <array>
#include <vector>

namespace refraster {

/// The relative error of the area by which a device divides the slopes of a triangle's planes, beyond that of a
/// triangle with two sides along the axes: it is the difference of two products of differences, and in a needle next to
/// nothing is left of them. Points in pixels, y either way.
class AreaError {
public:
  AreaError() = default;
  /// A triangle that reaches beyond the view may be cut into others: a fan from any corner of what is in view.
  AreaError(const std::array<Double2, 3>& corners, double width, double height);

  /// The largest of the triangle's own and of the pieces that reach to within `margin` of the point. Infinite without
  /// area.
  double at(const Double2& point, double margin) const;

private:
  double whole_ = 0;
  std::vector<Double2> in_view_; // empty if that is all of it
};

} // namespace refraster
