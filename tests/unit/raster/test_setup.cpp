// Set-up of triangles on the lattice, in lanes and alone, against whole numbers.

#include "raster/shade/attribute_setup_lanes.h"
#include "tests/support/for_all.h"
#include "tests/support/raster/triangles.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>

using namespace refraster;
using namespace refraster::test;

namespace {

constexpr int lanes = NumberTraits<Native<double>>::lanes;
using Corners = std::array<WindowVertex, 3>;

// Of a few subpixels, of some pixels, or as far as the guard band goes; corners often at one x, or at the last place.
Corners random_corners(Random& random) {
  constexpr std::int32_t reaches[] = {4, 4 * subpixels, 1 << 20, guard_band};
  const std::int32_t reach = reaches[random.below(4)];
  const auto place = [&] {
    return random.below(8) == 0 ? static_cast<std::int32_t>(random.sign()) * reach
                                : static_cast<std::int32_t>(random.below(2 * reach)) - reach;
  };
  Corners v;
  for (WindowVertex& corner : v) {
    const std::int32_t x = place(), y = place();
    corner = lattice_vertex(x, y, random.uniform(-1, 1), random.log_uniform(1e-3, 1e3));
  }
  if (random.below(4) == 0) v[1].x = v[0].x;
  if (random.below(4) == 0) v[2].y = v[static_cast<std::size_t>(random.below(2))].y;
  return v;
}

/// One triangle for each lane, all with area.
std::array<Corners, lanes> random_register(Random& random) {
  std::array<Corners, lanes> result;
  for (Corners& v : result) do
      v = random_corners(random);
    while (!set_up_scalar(v));
  return result;
}

std::array<CornerLanes<lanes>, 3> in_lanes(const std::array<Corners, lanes>& triangles) {
  std::array<CornerLanes<lanes>, 3> result;
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<PlacedVertex, lanes> placed;
    for (std::size_t lane = 0; lane < lanes; ++lane) placed[lane] = PlacedVertex::of(triangles[lane][k]);
    result[k] =
        gather_corners<lanes>([&](int lane) -> const PlacedVertex& { return placed[static_cast<std::size_t>(lane)]; });
  }
  return result;
}

} // namespace

TEST_CASE("a triangle set up alone has the edge functions and the order of corners of whole numbers") {
  for_all(20000, [](Random& random) {
    const Corners v = random_corners(random);
    const auto expected = set_up_scalar(v);
    const auto t = set_up_snapped(v);
    REQUIRE(t.has_value() == expected.has_value());
    if (!t) return;
    REQUIRE(t->corner == expected->corner);
    for (std::size_t k = 0; k < 3; ++k) {
      REQUIRE(t->edge[k].a == expected->a[k]);
      REQUIRE(t->edge[k].b == expected->b[k]);
      REQUIRE(t->edge[k].c == expected->c[k]);
    }
  });
}

TEST_CASE("triangles set up in lanes have the edge functions and depths of whole numbers") {
  for_all(5000, [](Random& random) {
    const std::array<Corners, lanes> triangles = random_register(random);
    const auto [v0, v1, v2] = in_lanes(triangles);
    const SnappedSetup<Native<double>, 1> t = set_up_snapped(v0, v1, v2);
    const auto depth = depth_plane(t);
    const auto thresholds = t.thresholds();
    for (int lane = 0; lane < lanes; ++lane) {
      const ScalarTriangle expected = set_up_scalar(triangles[static_cast<std::size_t>(lane)]).value();
      REQUIRE(t.size[lane] == static_cast<double>(expected.size));
      for (std::size_t k = 0; k < 3; ++k) {
        const SnappedEdge edge{expected.a[k], expected.b[k], 0};
        REQUIRE(t.a[k][lane] == static_cast<double>(edge.a));
        REQUIRE(t.b[k][lane] == static_cast<double>(edge.b));
        REQUIRE((0 > thresholds[k][lane]) == edge.owns_ties());
      }
      const std::int32_t x = random.below(max_image_side * subpixels), y = random.below(max_image_side * subpixels);
      const auto value = [&](std::size_t k) { return Native<double>(static_cast<double>(expected.at(k, x, y))); };
      REQUIRE(depth.at(value(1), value(2))[lane] == expected.depth(x, y));
    }
  });
}

TEST_CASE("edge functions modulo 2^32 are right at pixel centres near the triangle wherever they say so") {
  int wrapped = 0, large = 0;
  for_all(5000, [&](Random& random) {
    const std::array<Corners, lanes> triangles = random_register(random);
    std::array<Native<double>, 3> inverse_w;
    for (std::size_t k = 0; k < 3; ++k)
      for (int lane = 0; lane < lanes; ++lane)
        inverse_w[k].set(lane, triangles[static_cast<std::size_t>(lane)][k].inverse_w);
    const AttributeSetupLanes<lanes> t = attribute_setup_lanes<lanes>(in_lanes(triangles), inverse_w);
    for (int lane = 0; lane < lanes; ++lane) {
      const Corners& v = triangles[static_cast<std::size_t>(lane)];
      const ScalarTriangle expected = set_up_scalar(v).value();
      const double nearest = std::max({v[0].inverse_w, v[1].inverse_w, v[2].inverse_w});
      for (std::size_t k = 0; k < 3; ++k) {
        REQUIRE(t.corner[k].submitted[lane] == expected.corner[k]);
        REQUIRE(t.corner[k].weight[lane] == v[expected.corner[k]].inverse_w / nearest);
      }
      (t.wraps[lane] ? wrapped : large) += 1;
      if (!t.wraps[lane]) continue;
      // Inside, each value is at most `size`; at a centre half a pixel from there it may be half a pixel's change more.
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t most = expected.size + (std::abs(expected.a[k]) + std::abs(expected.b[k])) * (subpixels / 2);
        REQUIRE(most < std::int64_t{1} << 31);
        const std::int32_t x = v[0].x + random.below(subpixels), y = v[0].y + random.below(subpixels);
        const auto& edge = t.corner[k];
        const auto word = [](std::int32_t i) { return static_cast<std::uint32_t>(i); };
        const std::uint32_t value = word(edge.a[lane]) * word(x) + word(edge.b[lane]) * word(y) + word(edge.c[lane]);
        REQUIRE(value == static_cast<std::uint32_t>(expected.at(k, x, y)));
      }
    }
  });
  CHECK(wrapped > 1000);
  CHECK(large > 1000);
}
