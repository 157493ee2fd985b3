#pragma once
// A rough sea: a mesh of as many triangles as one likes.

#include <refraster/scene.h>

#include "scenes/synthesis/noise.h"

#include <cmath>

namespace refraster {

struct Quads {
  std::uint32_t columns, rows;
};

namespace waves_detail {

inline constexpr double half_height = 1.03 * 3 * 0.41421356237309503; // tan(45 / 2 degrees)
inline constexpr double half_width = half_height * 16 / 9;

/// u, v in [0, 1] over the frame. Octaves of noise, each turned against the last by the angle of the triangle 3, 4, 5,
/// so that no lattice shows. No slope is steep enough to hide another.
inline double height(double u, double v) {
  double x = 16 * u + 2, y = 9 * v + 18, sum = 0; // turning leaves both positive, as smooth_noise needs
  double strength = 0.05;
  for (std::uint32_t octave = 0; octave < 4; ++octave, strength *= 0.45) {
    sum += strength * smooth_noise(x, y, 1024, 1024, 11 + octave);
    const double turned = 2 * (0.8 * x + 0.6 * y);
    y = 2 * (0.8 * y - 0.6 * x) + 128;
    x = turned;
  }
  return sum;
}

} // namespace waves_detail

/// 2 columns rows triangles, which overlap a 16:9 frame by 3 % on each side when seen from (0, 0, 3) with a field of
/// view of 45 degrees.
inline Mesh waves(const Quads& quads) {
  using namespace waves_detail;
  Mesh mesh;
  for (std::uint32_t row = 0; row <= quads.rows; ++row)
    for (std::uint32_t column = 0; column <= quads.columns; ++column) {
      const double u = static_cast<double>(column) / quads.columns, v = static_cast<double>(row) / quads.rows;
      mesh.positions.emplace_back((2 * u - 1) * half_width, (2 * v - 1) * half_height, height(u, v));
      // The normal of a height field: minus its slopes, by differences over a thousandth of the frame.
      constexpr double step = 0.001;
      const double slope_x = (height(u + step, v) - height(u, v)) / (2 * step * half_width);
      const double slope_y = (height(u, v + step) - height(u, v)) / (2 * step * half_height);
      const double length = std::sqrt(slope_x * slope_x + slope_y * slope_y + 1);
      mesh.normals.emplace_back(-slope_x / length, -slope_y / length, 1 / length);
    }
  const std::uint32_t points = quads.columns + 1;
  for (std::uint32_t row = 0; row < quads.rows; ++row)
    for (std::uint32_t column = 0; column < quads.columns; ++column) {
      const std::uint32_t low_left = row * points + column, high_left = low_left + points;
      mesh.triangles.push_back({low_left, low_left + 1, high_left + 1});
      mesh.triangles.push_back({low_left, high_left + 1, high_left});
    }
  return mesh;
}

} // namespace refraster
