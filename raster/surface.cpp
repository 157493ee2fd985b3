#include "raster/surface.h"

#include "math/twofold.h"

#include <algorithm>
#include <cmath>

namespace refraster {

namespace {
// Line values lie between 1 and 2^52: above this no product of value and weight is subnormal, so that scaling by a
// power of two, as in a packet that holds a projective triangle, changes no digit.
template <class Real>
constexpr double least_weight = sizeof(Real) == 4 ? 0x1p-70 : 0x1p-900;
} // namespace

template <class Real>
SurfaceTriangle<Real> surface_triangle(const Scene& scene, const Geometry& geometry, const Bins& bins,
                                       std::uint32_t number) {
  const TriangleRef ref = triangle_ref(scene, geometry, number);
  const std::array<WindowVertex, 3> v = window_corners(geometry, ref);
  SurfaceTriangle<Real> t;
  t.object = ref.object;
  t.number = number;

  std::array<std::uint8_t, 3> corner{};
  if ((v[0].outcode | v[1].outcode | v[2].outcode) & outcode::unsnapped) {
    t.projective = &bins.projective_triangle(number);
    std::fill_n(t.value.begin(), 3, Real(1)); // line_values applies the projective weights before it rounds
    corner = t.projective->corner;
  } else {
    const SnappedTriangle set_up = *set_up_snapped(v);
    const std::array<double, 3> weight = perspective_weights(v, set_up.corner);
    for (std::size_t k = 0; k < 3; ++k) {
      const SnappedLine& line = set_up.line[k];
      t.line[3 * k] = static_cast<double>(line.a);
      t.line[3 * k + 1] = static_cast<double>(line.b);
      t.line[3 * k + 2] = static_cast<double>(line.c);
      t.value[k] = static_cast<Real>(weight[k] < least_weight<Real> ? 0 : weight[k]);
    }
    corner = set_up.corner;
  }

  // corner_value(k, c): component c at the triangle's corner k, in double; differences are taken before they are
  // rounded.
  const auto anchored = [&](Attribute attribute, auto&& corner_value) {
    const int n = components(attribute);
    Real* const at = &t.value[static_cast<std::size_t>(attribute)];
    for (int c = 0; c < n; ++c) {
      const double anchor = corner_value(0, c);
      at[c] = static_cast<Real>(anchor);
      at[n + c] = static_cast<Real>(corner_value(1, c) - anchor);
      at[2 * n + c] = static_cast<Real>(corner_value(2, c) - anchor);
    }
  };
  const auto world = [&](int k) -> const WorldVertex& {
    return geometry.world[ref.vertex[corner[static_cast<std::size_t>(k)]]];
  };
  anchored(Attribute::position, [&](int k, int c) { return world(k).position[c]; });
  // Normals count by their direction only. A power of two, common to the corners, keeps differences of huge ones in the
  // range of a float rung, and tiny ones above its end.
  const Double3 sizes(reciprocal_binade(world(0).normal), reciprocal_binade(world(1).normal),
                      reciprocal_binade(world(2).normal));
  const double normal_scale = minimum(sizes.x, minimum(sizes.y, sizes.z));
  anchored(Attribute::normal, [&](int k, int c) { return world(k).normal[c] * normal_scale; });

  const Mesh& mesh = *scene.objects[ref.object].mesh;
  if (mesh.uvs.empty()) {
    std::fill(t.value.begin() + static_cast<int>(Attribute::uv), t.value.end(), Real(0));
    t.uv_whole = {};
    return t;
  }
  std::array<std::array<double, 2>, 3> uv{};
  const auto& indices = mesh.triangles[ref.triangle];
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t c = 0; c < 2; ++c) {
      const double value = static_cast<double>(mesh.uvs[indices[corner[k]]][static_cast<int>(c)]);
      uv[k][c] = value;
    }
  for (std::size_t c = 0; c < 2; ++c) {
    const double least = std::min({uv[0][c], uv[1][c], uv[2][c]});
    t.uv_whole[c] = magnitude(least) < 1e300 ? std::floor(least) : 0; // only a finite uv has whole repeats
    // Exact: uv is a float and the difference of two doubles this close to it. Small negative ones stay as they are.
    if (least > -1 && least < 1) t.uv_whole[c] = 0;
    for (std::size_t k = 0; k < 3; ++k) uv[k][c] -= t.uv_whole[c];
    t.value[least_uv + c] = static_cast<Real>(std::min({uv[0][c], uv[1][c], uv[2][c]}));
    t.value[most_uv + c] = static_cast<Real>(std::max({uv[0][c], uv[1][c], uv[2][c]}));
  }
  anchored(Attribute::uv, [&](int k, int c) { return uv[static_cast<std::size_t>(k)][static_cast<std::size_t>(c)]; });
  return t;
}

template SurfaceTriangle<double> surface_triangle(const Scene&, const Geometry&, const Bins&, std::uint32_t);
template SurfaceTriangle<float> surface_triangle(const Scene&, const Geometry&, const Bins&, std::uint32_t);

Double3 face_normal(const Scene& scene, const Geometry& geometry, std::uint32_t number) {
  const TriangleRef ref = triangle_ref(scene, geometry, number);
  const Mesh& mesh = *scene.objects[ref.object].mesh;
  const auto corner = [&](std::size_t k) { return Double3(mesh.positions[mesh.triangles[ref.triangle][k]]); };
  // Of a needle the edges are nearly parallel: differences and products are carried to twice the precision, so that
  // what their difference leaves is good. Each edge is brought near unit length first: nothing overflows or vanishes.
  const Double3 p0 = corner(0), p1 = corner(1), p2 = corner(2);
  const double scale1 = reciprocal_binade(p1 - p0), scale2 = reciprocal_binade(p2 - p0);
  const auto edge = [&](const Double3& p, int c, double scale) {
    const Twofold<double> difference = exact_sum(p[c], -p0[c]);
    return Twofold<double>{difference.hi * scale, difference.lo * scale};
  };
  const auto minor = [&](int i, int j) {
    const Twofold<double> a = wide_product(edge(p1, i, scale1), edge(p2, j, scale2));
    const Twofold<double> b = wide_product(edge(p1, j, scale1), edge(p2, i, scale2));
    const Twofold<double> difference = exact_sum(a.hi, -b.hi);
    return difference.hi + (difference.lo + (a.lo - b.lo));
  };
  return geometry.transforms[ref.object].world_from_normal * Double3(minor(1, 2), minor(2, 0), minor(0, 1));
}

} // namespace refraster
