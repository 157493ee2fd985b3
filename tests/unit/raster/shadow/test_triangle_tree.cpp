// What a ray to a light crosses: by the tree, by double with a bound on its errors, by integers, and by Cramer's rule
// in rational numbers.

#include "tests/support/raster/shadow_cases.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

using namespace refraster;
using namespace refraster::test;

namespace {

/// What the cases of a run were: that they are worth something.
struct Tally {
  std::uint64_t pairs = 0, in_shadow = 0, uncertain = 0, tests = 0;
};

/// Points of one mesh and lights, each pair of them by all ways.
void compare(std::uint64_t seed, MeshKind kind, int pairs, Tally& tally) {
  Random random(seed);
  const MeshParts parts = random_mesh(random, kind);
  const WorldMesh mesh = parts.mesh();
  const auto count = static_cast<int>(parts.triangle.size());
  TriangleTree tree;
  tree.build(mesh, 1 + random.below(3));
  for (int i = 0; i < pairs; ++i) {
    const auto own = static_cast<std::uint32_t>(random.below(count));
    const SurfacePoint point = random_point(random, mesh.at(own));
    const LightPlace light = random_light(random, parts);
    const ShadowRay ray(point, light);
    const RationalVec3 p = rational_point(point);
    std::optional<std::uint32_t> first;
    for (std::uint32_t t = 0; t < parts.triangle.size(); ++t) {
      const WorldTriangle triangle = mesh.at(t);
      const bool truth = crosses_in_rationals(p, light, triangle);
      if (truth && !first) first = t;
      const std::optional<bool> certain = ray.crosses_certainly(triangle);
      ++tally.tests, tally.uncertain += !certain;
      if ((certain && *certain != truth) || ray.crosses(triangle) != truth ||
          ((!certain || i % 8 == 0) && ray.crosses_exactly(triangle) != truth)) {
        CAPTURE(seed);
        CAPTURE(i);
        CAPTURE(t);
        CHECK(certain.value_or(truth) == truth);
        CHECK(ray.crosses(triangle) == truth);
        REQUIRE(ray.crosses_exactly(triangle) == truth);
      }
    }
    if (first == own || tree.any_crosses(mesh, ray, own) != first.has_value() ||
        tree.first_crossed(mesh, ray, {}) != first) {
      CAPTURE(seed);
      CAPTURE(i);
      CHECK(first != own); // a point is in the plane of its own triangle
      CHECK(tree.any_crosses(mesh, ray, own) == first.has_value());
      REQUIRE(tree.first_crossed(mesh, ray, {}) == first);
    }
    ++tally.pairs, tally.in_shadow += first.has_value();
  }
}

void compare_many(std::uint64_t first_seed, int meshes, int pairs) {
  for (int kind = 0; kind < static_cast<int>(MeshKind::count_); ++kind) {
    Tally tally;
    for (int i = 0; i < meshes; ++i)
      compare(first_seed + static_cast<std::uint64_t>(i), static_cast<MeshKind>(kind), pairs, tally);
    CAPTURE(kind);
    MESSAGE("kind " << kind << ": " << tally.pairs << " pairs, " << tally.in_shadow << " in shadow, " << tally.uncertain
                    << " of " << tally.tests << " left to integers");
    CHECK(tally.in_shadow * 20 > tally.pairs);
    CHECK(tally.in_shadow * 20 < tally.pairs * 19);
    CHECK(tally.uncertain > 0);
  }
}

} // namespace

TEST_CASE("a ray to a light crosses what it does in rational numbers") {
  compare_many(1, 8, 25);
}

TEST_SUITE("slow") {
  TEST_CASE("a ray to a light crosses what it does in rational numbers, 20,000 pairs") {
    compare_many(1000, 40, 100);
  }
}

TEST_SUITE("long") {
  TEST_CASE("a ray to a light crosses what it does in rational numbers, a million pairs") {
    compare_many(100000, 1000, 200);
  }
}
