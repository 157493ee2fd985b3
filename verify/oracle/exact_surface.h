#pragma once
// The point of a surface that a pixel shows.

#include "raster/transform.h"
#include "verify/oracle/exact.h"

#include <array>
#include <optional>
#include <vector>

namespace refraster::oracle {

struct SurfacePoint {
  Exact3 position, normal; // world space; normal of unit length
  bool has_uv = true;      // whether the triangle has texture coordinates
  Exact u, v;
  Exact u_right, v_right, u_down, v_down; // their change by one pixel
};

/// The centre of a pixel of the image, and the triangle that it shows, counted from 0 in its object's mesh.
struct Place {
  int x = 0, y = 0;
  std::size_t object = 0, triangle = 0;
};

/// Camera and matrices of a scene, from its numbers as they are.
class ExactGeometry {
public:
  ExactGeometry(const Scene& scene, int width, int height);

  /// Perspective-correct. Where the corners stand in the window is by rule (docs/conventions.md) what the vertex stage
  /// says in double, rounded to the lattice of 1/256 pixel, and is taken from raster/transform.h; a triangle that
  /// reaches behind the eye is cut as docs/architecture.md has it. All else is computed here. Nothing where the normal
  /// is 0 or a coordinate not finite.
  std::optional<SurfacePoint> surface_at(const Place& place) const;

private:
  struct Model {
    std::array<Exact3, 3> axes;    // columns of the 3 x 3 part
    std::array<Exact3, 3> normals; // of the matrix for normals, up to a positive factor
    ObjectTransform in_double;
  };
  struct Corner;
  Model model_of(const Object& object) const;
  std::optional<Corner> corner(const Place& place, std::size_t k) const;
  Exact3 window_point(const Exact& x, const Exact& y, const Exact& w) const;
  Corner between(const Corner& front, const Corner& back) const;
  std::vector<Corner> in_front(const std::array<Corner, 3>& corners) const;

  const Scene& scene_;
  int width_, height_;
  Exact3 eye_, back_; // the camera looks along -back_
  std::vector<Model> models_;
};

} // namespace refraster::oracle
