#pragma once
// Triangle set-up: three canonical points become three edge functions, a depth and the weights of perspective
// interpolation. Nothing is clipped to the view: a triangle's values are those of the whole triangle, whatever plane it
// crosses.

#include "raster/vertex/subpixel.h"
#include "raster/vertex/transform.h"

#include <array>
#include <cstdint>
#include <optional>

namespace refraster {

enum class Facing { front, back }; // front: its corners run counter-clockwise in the image

/// A triangle whose three vertices lie on the lattice, nearly all of them, as integers: SnappedSetup of it alone.
struct SnappedTriangle {
  std::array<SnappedEdge, 3> edge;      // edge[k] is opposite corner[k], positive inside
  std::array<std::uint8_t, 3> corner{}; // which submitted vertex stands at each place
};

/// Part of a triangle with a corner at or behind the eye plane, or beyond the guard band: a triangle all of whose
/// vertices have w > 0. A vertex is a homogeneous window point (X : Y : W), and an edge the line through two of them,
/// computed without rounding whatever the coordinates and then cut to 61 bits of slope, exactly through any end that is
/// on the lattice. A sample p is covered where p = sum of lambda_k (X : Y : W)_k with all lambda_k >= 0. Olano and
/// Greer, "Triangle scan conversion using 2D homogeneous coordinates", 1997.
struct ProjectivePiece {
  std::array<ProjectiveEdge, 3> edge; // edge[k] is opposite vertex k, positive inside
  Facing facing = Facing::front;
  /// nu_k = edge[k].at(sample) weight[k]: the sample's clip point is the sum of nu_k vertex_k.
  std::array<double, 3> weight{};
  std::array<double, 3> z{}, w{};                  // clip coordinates of the vertices
  std::array<std::array<double, 3>, 3> fraction{}; // vertex k is the sum of fraction[k][c] corner_c; none is negative

  bool covers(std::int32_t x, std::int32_t y) const;
  /// z / w at a sample. Not in [-1, 1] where a depth plane cuts it off.
  double depth(std::int32_t x, std::int32_t y) const;
};

/// A triangle with such a corner: itself; or, where corners lie at or behind the eye plane, what lies of it beyond half
/// the distance of the near plane, as one or two pieces. An edge that goes behind the eye is cut there, at a point that
/// depends on the edge alone, so that neighbours meet; what is interpolated is still that of the whole triangle.
///
/// Why an edge is cut, and does not run on to its end behind the eye as homogeneous coordinates allow: snapping may
/// move the end in front by half a subpixel, and the end behind pulls at the other side of the eye. Let both be a
/// million units away: in the window they are a thousandth of a subpixel apart, and the line through them would be
/// anywhere. Between points that all lie in front, snapping moves nothing further than half a subpixel.
struct ProjectiveTriangle {
  std::array<ProjectivePiece, 2> piece;
  int pieces = 0;
  std::array<std::uint8_t, 3> corner{}; // which submitted vertex stands at each place
  Facing facing = Facing::front;
};

/// The size of an image, and the least distance w at which anything is drawn.
struct ImageShape {
  int width = 0, height = 0;
  double near = 0;
};

ImageShape image_shape(const FrameInput& input);

/// Nothing if the triangle has no area on the lattice.
std::optional<SnappedTriangle> set_up_snapped(const std::array<WindowVertex, 3>& v);
/// Nothing if the three points are on one line, or all behind the eye. `clip` are the vertices' clip coordinates, all
/// finite; not used of a vertex that is on the lattice.
std::optional<ProjectiveTriangle> set_up_projective(const std::array<WindowVertex, 3>& v,
                                                    const std::array<Double4, 3>& clip, const ImageShape& shape);

} // namespace refraster
