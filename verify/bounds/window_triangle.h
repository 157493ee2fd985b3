#pragma once
// A triangle's planes over the window, in double and from corners that are not rounded.

#include "math/vec.h"

#include <array>

namespace refraster {

/// In homogeneous window coordinates (x w, y w, w), x to the right and y down in pixels. A corner may lie behind the
/// eye. Over the window, l[i].(x, y, 1) is the perspective-correct weight of corner i, divided by the w of the surface
/// there:
///     1 / w = sum l[i],     f / w = sum l[i] f[i],     z_ndc = sum l[i] z_clip[i].
struct WindowTriangle {
  std::array<Double3, 3> l{Double3(0), Double3(0), Double3(0)};
  double determinant = 0; // 0: it has no area, and no weights

  WindowTriangle() = default;
  explicit WindowTriangle(const std::array<Double3, 3>& corner) {
    for (std::size_t i = 0; i < 3; ++i) l[i] = cross(corner[(i + 1) % 3], corner[(i + 2) % 3]);
    determinant = dot(corner[0], l[0]);
    if (determinant != 0)
      for (Double3& line : l) line /= determinant;
  }

  bool is_flat() const { return determinant == 0; }
  std::array<double, 3> at(double x, double y) const {
    const auto value = [&](const Double3& line) { return line.x * x + line.y * y + line.z; };
    return {value(l[0]), value(l[1]), value(l[2])};
  }
};

} // namespace refraster
