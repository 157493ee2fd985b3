#pragma once
// Triangle set-up: three canonical points become three lines, a depth and the weights of perspective interpolation.
// No triangle is ever clipped, so no value of it can depend on the clip planes.

#include "raster/subpixel.h"
#include "raster/transform.h"

#include <array>
#include <cstdint>
#include <optional>

namespace refraster {

enum class Facing { front, back }; // front: its corners run counter-clockwise in the image

/// A triangle whose three vertices lie on the lattice: nearly all of them.
///
/// The corners are taken in an order that depends on their places only, so that the same triangle submitted with its
/// vertices rotated or reversed has the same depth and the same attributes at every sample, bit for bit.
struct SnappedTriangle {
  std::array<SnappedLine, 3> line;      // line[k] is opposite corner[k], positive inside
  std::array<std::uint8_t, 3> corner{}; // which submitted vertex stands at each place
  Facing facing = Facing::front;
  // z / w at a sample = z0 + line[1].at(sample) slope1 + line[2].at(sample) slope2, kept within [z_min, z_max].
  double z0 = 0, slope1 = 0, slope2 = 0, z_min = 0, z_max = 0;
  std::int32_t x_min = 0, x_max = 0, y_min = 0, y_max = 0; // bounding box, subpixels

  double depth(std::int32_t x, std::int32_t y) const {
    const double z =
        z0 + static_cast<double>(line[1].at(x, y)) * slope1 + static_cast<double>(line[2].at(x, y)) * slope2;
    return z < z_min ? z_min : z > z_max ? z_max : z;
  }
};

/// The weights of perspective interpolation, in the order of `corner`: attribute f at a sample = sum of mu_k f_k / sum
/// of mu_k with mu_k = line[k].at(sample) weight[k]. 0 < weight <= 1.
std::array<double, 3> perspective_weights(const std::array<WindowVertex, 3>& v,
                                          const std::array<std::uint8_t, 3>& corner);

/// A triangle with a vertex at or behind the eye plane, or beyond the guard band. A vertex is a homogeneous window
/// point (X : Y : W), and an edge the line through two of them, computed without rounding whatever the coordinates and
/// then cut to 61 bits of slope: the same for both triangles that share the edge, and exactly through any end that is
/// on the lattice. A sample p is covered where p = sum of lambda_k (X : Y : W)_k with all lambda_k >= 0, which
/// is true of the part in front of the eye and of no other.
/// Olano and Greer, "Triangle scan conversion using 2D homogeneous coordinates", 1997.
struct ProjectiveTriangle {
  std::array<ProjectiveLine, 3> line; // as above
  std::array<std::uint8_t, 3> corner{};
  Facing facing = Facing::front;
  std::array<double, 3> weight{}; // see perspective_weights
  std::array<double, 3> z{}, w{}; // clip coordinates

  /// z / w of the triangle's plane at a sample that it covers. Not in [-1, 1] where a depth plane cuts it off.
  double depth(std::int32_t x, std::int32_t y) const;
};

/// Nothing if the triangle has no area on the lattice.
std::optional<SnappedTriangle> set_up_snapped(const std::array<WindowVertex, 3>& v);
/// Nothing if the three points are on one line. `clip` are the vertices' clip coordinates, all finite.
std::optional<ProjectiveTriangle> set_up_projective(const std::array<WindowVertex, 3>& v,
                                                    const std::array<Double4, 3>& clip, int width, int height);

} // namespace refraster
