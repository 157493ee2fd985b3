#pragma once
// The vertex stage in long double, from the rules in docs/conventions.md; and what the renderer's own stores.

#include <refraster/scene.h>

#include "raster/vertex/transform.h"
#include "tests/support/slow/slow_vector.h"

#include <vector>

namespace refraster::slow {

/// A vertex: its homogeneous window point in pixels, y down, and the factor between that and its clip coordinates.
struct Corner {
  Vec window;      // x, y, w
  Real factor = 1; // clip = point * factor
  Real x = 0, y = 0, z = 0, w = 0;
  Vec position, normal; // world space; normal of any length
  bool has_uv = false;
  Real u = 0, v = 0;
  Vec colour = {1, 1, 1};
  Vec tangent; // unit, or 0: the mesh has none
  Real handedness = 0;
};

class Viewer {
public:
  Viewer(const Camera& camera, int width, int height);

  /// Fills what the position decides.
  void place(Corner& corner) const;

  /// Where the edge from a corner in front of the eye to one behind ends: at half the distance of the near plane, or of
  /// the corner, should that be nearer. Not snapped.
  Corner cut(const Corner& front, const Corner& back) const;

  /// x and y in pixels times w, and w: not snapped.
  Vec window_of(const Corner& corner) const;

private:
  Real width_, height_, near_, cotangent_, z_scale_, z_offset_;
  Vec eye_, back_, right_, up_;
};

/// Every vertex of an object, worked out from the numbers of the scene.
std::vector<Corner> corners_of(const Object& object, const Viewer& viewer);

/// The same from what raster/vertex/transform.h stores of object number `index`.
std::vector<Corner> stored_corners(const Scene& scene, const Geometry& geometry, std::size_t index, int width,
                                   int height);

} // namespace refraster::slow
