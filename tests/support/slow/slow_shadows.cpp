#include "tests/support/slow/slow_shadows.h"

#include "tests/support/slow/slow_vertices.h"

#include <algorithm>
#include <cmath>

namespace refraster::slow {
namespace {

// Points are good to a few 2^-53 of the scene's size here, where double interpolates them; the doubt is far more.
constexpr Real doubt = 0x1p-36L;

Real size(Vec a) {
  return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
}

} // namespace

ShadowCasters::ShadowCasters(const Scene& scene) {
  const Viewer viewer(scene.camera, 1, 1);
  for (const Object& object : scene.objects) {
    const std::vector<Corner> corners = corners_of(object, viewer);
    for (std::uint32_t t = 0; t < object.mesh->triangles.size(); ++t) {
      const auto& v = object.mesh->triangles[t];
      casters_.push_back({&object, t, {corners[v[0]].position, corners[v[1]].position, corners[v[2]].position}});
    }
  }
}

std::optional<bool> ShadowCasters::sees(const Seen& seen, Vec to, bool is_direction) const {
  const Vec way = is_direction ? to : to - seen.position;
  bool doubtful = false;
  for (const auto& [object, triangle, corner] : casters_) {
    if (object == seen.object && triangle == seen.triangle) continue;
    // Moeller and Trumbore: (t, u, v) of seen.position + t way = corner0 + u ab + v ac, each times the determinant.
    const Vec ab = corner[1] - corner[0], ac = corner[2] - corner[0], from = seen.position - corner[0];
    const Vec p = cross(way, ac), q = cross(from, ab);
    const Real determinant = dot(ab, p), turn = determinant < 0 ? -1 : 1, whole = determinant * turn;
    const Real u = dot(from, p) * turn, v = dot(way, q) * turn, t = dot(ac, q) * turn;
    // What each may be off by: of products of lengths, in which the surface point's error counts with its coordinates.
    const Real reach = size(seen.position) + size(corner[0]) + size(ab) + size(ac);
    const Real weights_off = doubt * reach * size(way) * (size(ab) + size(ac));
    const Real t_off = doubt * reach * size(ab) * size(ac);
    const Real w = whole - u - v;
    if (u < -weights_off || v < -weights_off || w < -2 * weights_off) continue;
    if (t < -t_off || (!is_direction && t > whole + t_off + weights_off)) continue;
    const bool inside = u > weights_off && v > weights_off && w > 2 * weights_off;
    if (inside && t > t_off && (is_direction || t < whole - t_off - weights_off)) return false;
    doubtful = true;
  }
  if (doubtful) return std::nullopt;
  return true;
}

} // namespace refraster::slow
