#pragma once
// From a visible triangle to what is interpolated over it: perspective-correct attributes at pixel centres, in the
// number of a rung. Here the rung begins.

#include "math/rungs.h"
#include "raster/bin.h"

#include <array>
#include <cstdint>

namespace refraster {

/// Where the attributes of a SurfaceTriangle stand: attribute f has its components at f, f + 1 … for corner 0, and then
/// the differences of corner 1 and of corner 2 to it.
enum class Attribute : std::uint8_t { position = 3, normal = 12, uv = 21 };
/// Where the least and the greatest uv of the three corners stand.
inline constexpr int least_uv = 27, most_uv = 29;
inline constexpr int components(Attribute a) {
  return a == Attribute::uv ? 2 : 3;
}

/// What shading needs of one visible triangle, attributes in the rung's precision.
///
/// An attribute is kept as its value at one corner and the differences to the other two: f = f0 + b1 (f1 - f0) +
/// b2 (f2 - f0). So a value that is the same at all three corners comes out unchanged, bit for bit, and nothing is
/// anchored at the framebuffer's origin, where a small far triangle would lose its digits.
template <class Real>
struct SurfaceTriangle {
  std::array<double, 9> line;     // a, b, c of each line: exact; unused where projective
  std::array<Real, 31> value;     // [0..2] weights of perspective, see SnappedTriangle; then as Attribute says
  std::array<double, 2> uv_whole; // whole repeats taken off uv, so that it keeps its fraction's digits
  const ProjectiveTriangle* projective = nullptr;
  std::uint32_t object = 0;
  std::uint32_t number = 0; // in the frame
};
static_assert(sizeof(SurfaceTriangle<float>) % sizeof(double) == 0, "gathers step through an array of them");

template <class Real>
SurfaceTriangle<Real> surface_triangle(const Scene& scene, const Geometry& geometry, const Bins& bins,
                                       std::uint32_t number);

extern template SurfaceTriangle<double> surface_triangle(const Scene&, const Geometry&, const Bins&, std::uint32_t);
extern template SurfaceTriangle<float> surface_triangle(const Scene&, const Geometry&, const Bins&, std::uint32_t);

/// The triangle's own normal in world space, from its winding: for places where the mesh gives none. May be 0.
Double3 face_normal(const Scene& scene, const Geometry& geometry, std::uint32_t number);

} // namespace refraster
