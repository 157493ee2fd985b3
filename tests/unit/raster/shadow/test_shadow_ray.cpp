// What a ray to a light crosses where it begins, ends or runs on a triangle: docs/shadows.md.

#include "tests/support/raster/shadow_cases.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <utility>

using namespace refraster;
using namespace refraster::test;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The point (0, 0, 0) of a triangle in the plane z = 0.
const SurfacePoint origin{{Double3(-1, -1, 0), Double3(1, -1, 0), Double3(0, 2, 0)}, {1, 1, 1}};

LightPlace lamp(double x, double y, double z) {
  return {LightPlace::Kind::point, {x, y, z}};
}
LightPlace sun(double x, double y, double z) {
  return {LightPlace::Kind::direction, {x, y, z}};
}

/// In the plane z.
WorldTriangle level(double z, double size = 1) {
  return {Double3(-size, -size, z), Double3(size, -size, z), Double3(0, 2 * size, z)};
}

/// By every way there is.
bool crosses(const LightPlace& light, const WorldTriangle& triangle, const SurfacePoint& from = origin) {
  const ShadowRay ray(from, light);
  const bool answer = ray.crosses(triangle);
  CHECK(ray.crosses_exactly(triangle) == answer);
  CHECK(ray.crosses_certainly(triangle).value_or(answer) == answer);
  for (const auto& [a, b, c] : {std::array{1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}) {
    const auto at = [&](int i) { return triangle[static_cast<std::size_t>(i)]; };
    CHECK(ray.crosses({at(a), at(b), at(c)}) == answer);
  }
  MeshParts mesh;
  mesh.add(triangle);
  TriangleTree tree;
  tree.build(mesh.mesh(), 1);
  CHECK(tree.any_crosses(mesh.mesh(), ray, {}) == answer);
  return answer;
}

} // namespace

TEST_CASE("a light is taken by what lies between, and by nothing before or behind") {
  CHECK(crosses(lamp(0, 0, 2), level(1)));
  CHECK_FALSE(crosses(lamp(0, 0, 2), level(3)));
  CHECK_FALSE(crosses(lamp(0, 0, 2), level(-1)));
  CHECK(crosses(sun(0, 0, 1e-300), level(1e300, 1e300)));
  CHECK_FALSE(crosses(sun(0, 0, 1e300), level(-1e-300, 1e300)));
  CHECK(crosses(lamp(0, 0, -2), level(-1)));
}

TEST_CASE("neither the plane that a point lies in takes its light, nor that of the light") {
  CHECK_FALSE(crosses(lamp(0, 0, 2), level(0)));
  CHECK_FALSE(crosses(lamp(0, 0, 2), level(2)));
  CHECK_FALSE(crosses(lamp(0, 0, 2), origin.corner));
  CHECK(crosses(lamp(0, 0, 2), level(std::numeric_limits<double>::denorm_min())));
  CHECK(crosses(lamp(0, 0, 2), level(std::nextafter(2, 0))));
  CHECK_FALSE(crosses(lamp(0, 0, 2), level(std::nextafter(2, 3))));
}

TEST_CASE("a ray through an edge or a corner crosses every triangle there, and so passes between no two") {
  const Double3 left(-1, 0, 1), right(1, 0, 1), before(0, -1, 1), behind(0, 1, 1), middle(0, 0, 1);
  CHECK(crosses(lamp(0, 0, 2), {left, right, before}));
  CHECK(crosses(lamp(0, 0, 2), {left, right, behind}));
  for (const auto& [a, b] : {std::pair{left, before}, {before, right}, {right, behind}, {behind, left}})
    CHECK(crosses(sun(0, 0, 3), {middle, a, b}));
  CHECK_FALSE(crosses(lamp(0, 0, 2), {left, right + Double3(0, -1e-300, 0), before}));
  CHECK(crosses(lamp(0, 0, 2), {left, right + Double3(0, 1e-300, 0), before}));
}

TEST_CASE("a ray within a triangle's plane does not cross it, but those that stand on its edges") {
  const WorldTriangle upright{Double3(0, -1, 1), Double3(0, 1, 1), Double3(0, 0, 3)};
  CHECK_FALSE(crosses(lamp(0, 0, 5), upright));
  CHECK(crosses(lamp(0, 0, 5), {Double3(0, -1, 1), Double3(0, 1, 1), Double3(1, 0, 1)}));
}

TEST_CASE("what has no area takes no light") {
  const Double3 p(0, 0, 1);
  CHECK_FALSE(crosses(lamp(0, 0, 2), {p, p, p}));
  CHECK_FALSE(crosses(lamp(0, 0, 2), {p, p, Double3(1, 1, 1)}));
  CHECK_FALSE(crosses(lamp(0, 0, 2), {Double3(-1, 0, 1), Double3(1, 0, 1), p}));
}

TEST_CASE("a light at the surface is seen, and so is everything from a point that is none") {
  CHECK_FALSE(crosses(lamp(0, 0, 0), level(1)));
  CHECK_FALSE(crosses(lamp(0, 0, 0), level(0)));
  for (const SurfacePoint& none :
       {SurfacePoint{origin.corner, {0, 0, 0}}, SurfacePoint{origin.corner, {1, infinite, 1}},
        SurfacePoint{{Double3(infinite, 0, 0), Double3(0), Double3(1)}, {1, 1, 1}}})
    CHECK_FALSE(crosses(lamp(0, 0, 2), level(1), none));
  CHECK_FALSE(crosses(sun(0, 0, 0), level(1)));
}

TEST_CASE("a point is where its weights say, however small or large they are, and not where that rounds to") {
  // One third of the way from -1 to 1 is no double. A triangle that stands on the point, and leans over it by less than
  // any double there.
  const double w = 0x1p-1074;
  for (const double scale : {w, 1e-300, 1.0, 1e300}) {
    const SurfacePoint third{{Double3(-1, 0, 0), Double3(0, 0, 0), Double3(0, 1, 0)}, {scale, scale + scale, 0}};
    const double below = -1.0 / 3; // 1.8e-17 above -1/3
    CHECK_FALSE(crosses(sun(0, 0, 1), {Double3(below, -1, 1), Double3(below, 1, 1), Double3(2, 0, 1)}, third));
    CHECK(crosses(sun(0, 0, 1), {Double3(below, -1, 1), Double3(below, 1, 1), Double3(-2, 0, 1)}, third));
  }
}

TEST_CASE("coordinates of all sizes are good for shadows") {
  for (int e = -1000; e <= 1000; e += 40) {
    const double s = std::ldexp(1.0, e);
    CAPTURE(e);
    const auto scaled = [&](const WorldTriangle& t) { return WorldTriangle{t[0] * s, t[1] * s, t[2] * s}; };
    const SurfacePoint from{scaled(origin.corner), origin.weight};
    CHECK(crosses(lamp(0, 0, 2 * s), scaled(level(1)), from));
    CHECK_FALSE(crosses(lamp(0, 0, 2 * s), scaled(level(3)), from));
    CHECK_FALSE(crosses(lamp(0, 0, 2 * s), scaled({Double3(0.01, 0, 1), Double3(1, 0, 1), Double3(1, 1, 1)}), from));
    CHECK(crosses(sun(s, 0, s), scaled({Double3(0.9, -1, 1), Double3(1.1, -1, 1), Double3(1, 1, 1)}), from));
  }
  const double huge = std::numeric_limits<double>::max();
  CHECK(crosses(lamp(0, 0, huge), level(1)));
  CHECK_FALSE(crosses(lamp(0, 0, -huge), level(1)));
  CHECK(crosses(lamp(0, 0, huge), {Double3(-1e300, -1, 1e300), Double3(1e300, -1, 1e300), Double3(0, 1e300, 1e300)}));
}

TEST_CASE("triangles with corners that are not finite are left out of the tree, and the others are in it") {
  MeshParts parts;
  parts.add(WorldTriangle{Double3(infinite, 0, 1), Double3(1), Double3(2)});
  parts.add(level(1));
  parts.add(WorldTriangle{Double3(0, std::numeric_limits<double>::quiet_NaN(), 1), Double3(1), Double3(2)});
  const WorldMesh mesh = parts.mesh();
  TriangleTree tree;
  tree.build(mesh, 1);
  const ShadowRay ray(origin, lamp(0, 0, 2));
  CHECK(tree.any_crosses(mesh, ray, {}));
  CHECK_FALSE(tree.any_crosses(mesh, ray, 1));
  CHECK(tree.first_crossed(mesh, ray, {}) == std::uint32_t{1});
  tree.build(MeshParts().mesh(), 2);
  CHECK_FALSE(tree.any_crosses(mesh, ray, {}));
}

TEST_CASE("a large tree is one of as many threads as there are, and each triangle is in it") {
  Random random(3);
  MeshParts parts;
  for (int i = 0; i < 30000; ++i) {
    const Double3 p = place(random, 10);
    parts.add(WorldTriangle{p, p + place(random, 0.2), p + place(random, 0.2)});
  }
  const WorldTriangle same{parts.position[0], parts.position[1], parts.position[2]};
  for (int i = 0; i < 5000; ++i) parts.add(same); // which no plane parts
  const WorldMesh mesh = parts.mesh();
  TriangleTree trees[3];
  trees[0].build(mesh, 1), trees[1].build(mesh, 2), trees[2].build(mesh, 7);
  int in_shadow = 0;
  for (int i = 0; i < 300; ++i) {
    const auto own = static_cast<std::uint32_t>(random.below(static_cast<int>(mesh.triangle.size())));
    const ShadowRay ray(random_point(random, mesh.at(own)), random_light(random, parts));
    std::optional<std::uint32_t> first;
    for (std::uint32_t t = 0; t < mesh.triangle.size() && !first; ++t)
      if (t != own && ray.crosses(mesh.at(t))) first = t;
    in_shadow += first.has_value();
    for (const TriangleTree& tree : trees) {
      REQUIRE(tree.any_crosses(mesh, ray, own) == first.has_value());
      REQUIRE(tree.first_crossed(mesh, ray, own) == first);
    }
  }
  CHECK(in_shadow > 30);
  CHECK(in_shadow < 270);
}
