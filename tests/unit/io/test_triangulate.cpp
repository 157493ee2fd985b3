#include "io/mesh/obj_faces.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <random>

namespace refraster::test {
namespace {

using Polygon = std::vector<Float3>;

Double2 flat(const Float3& p) {
  return Double2(p);
}

/// a x b; exact for small integer coordinates.
double cross(const Double2& a, const Double2& b) {
  return a.x * b.y - a.y * b.x;
}

/// Twice the signed area in the xy plane.
double turn(const Float3& a, const Float3& b, const Float3& c) {
  return cross(flat(b) - flat(a), flat(c) - flat(a));
}

enum class Turn { left, left_or_straight };

/// Triangles whose directed edges sum up to the polygon's, and that all turn as it does, cover each point as often as
/// the polygon winds round it: once inside and not at all outside. That is all there is to a triangulation.
void check_triangulation(const Polygon& polygon, Turn allowed = Turn::left) {
  const auto triangles = triangulate(polygon);
  REQUIRE(triangles.size() == polygon.size() - 2);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& [a, b, c] : triangles) {
    if (allowed == Turn::left) CHECK(turn(polygon[a], polygon[b], polygon[c]) > 0);
    else CHECK(turn(polygon[a], polygon[b], polygon[c]) >= 0);
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      ++edges[{from, to}];
      --edges[{to, from}];
    }
  }
  const auto n = static_cast<std::uint32_t>(polygon.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    --edges[{i, (i + 1) % n}];
    ++edges[{(i + 1) % n, i}];
  }
  CHECK(std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; }));
}

} // namespace

TEST_CASE("a convex polygon becomes the fan of its first corner") {
  const Polygon hexagon = {{2, 0, 0}, {1, 2, 0}, {-1, 2, 0}, {-2, 0, 0}, {-1, -2, 0}, {1, -2, 0}};
  CHECK(triangulate(hexagon) == std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}});
}

TEST_CASE("a concave quad is cut at its concave corner, wherever it begins") {
  const Polygon arrow = {{0, 0, 0}, {4, 4, 0}, {0, 2, 0}, {-4, 4, 0}};
  for (std::ptrdiff_t first = 0; first < 4; ++first) {
    Polygon turned = arrow;
    std::rotate(turned.begin(), turned.begin() + first, turned.end());
    check_triangulation(turned);
  }
}

TEST_CASE("a comb, a spiral and a star are cut into triangles that cover them once") {
  Polygon comb = {{0, -1, 0}};
  for (int tooth = 0; tooth < 20; ++tooth) {
    comb.insert(comb.begin(), {static_cast<float>(2 * tooth), 0, 0});
    comb.insert(comb.begin(), {static_cast<float>(2 * tooth + 1), 10, 0});
  }
  std::rotate(comb.begin(), comb.end() - 1, comb.end());
  comb.insert(comb.begin() + 1, {40, -1, 0});
  check_triangulation(comb);
  check_triangulation({{0, 0, 0},
                       {10, 0, 0},
                       {10, 10, 0},
                       {2, 10, 0},
                       {2, 4, 0},
                       {6, 4, 0},
                       {6, 6, 0},
                       {4, 6, 0},
                       {4, 8, 0},
                       {8, 8, 0},
                       {8, 2, 0},
                       {0, 2, 0}});
  check_triangulation({{0, 10, 0},
                       {-2, 3, 0},
                       {-10, 3, 0},
                       {-4, -2, 0},
                       {-6, -9, 0},
                       {0, -5, 0},
                       {6, -9, 0},
                       {4, -2, 0},
                       {10, 3, 0},
                       {2, 3, 0}});
}

TEST_CASE("corners on a straight edge stay corners, so that neighbours meet without a gap") {
  check_triangulation({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {0, 1, 0}},
                      Turn::left_or_straight);
  check_triangulation({{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 4, 0}});
}

TEST_CASE("a hole that is joined to the outline by a bridge stays a hole") {
  const Polygon framed = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {0, 0, 0},
                          {3, 3, 0}, {3, 6, 0}, {6, 6, 0}, {6, 3, 0}, {3, 3, 0}};
  check_triangulation(framed, Turn::left_or_straight);
}

TEST_CASE("random polygons round a point are covered once") {
  std::mt19937 random(7);
  for (int trial = 0; trial < 500; ++trial) {
    // Directions in order of angle, each with a distance of its own: a simple polygon. Integer coordinates, so that
    // turn() is exact here; those of one direction are left out.
    std::uniform_int_distribution<int> coordinate(-200, 200);
    Polygon polygon;
    for (int i = 0; i < 40; ++i) {
      const Float3 p(static_cast<float>(coordinate(random)), static_cast<float>(coordinate(random)), 0);
      const bool taken =
          std::any_of(polygon.begin(), polygon.end(), [&](const Float3& q) { return cross(flat(p), flat(q)) == 0; });
      if (!taken) polygon.push_back(p);
    }
    const auto lower = [](const Float3& p) { return p.y < 0 || (p.y == 0 && p.x < 0); };
    std::sort(polygon.begin(), polygon.end(), [&](const Float3& a, const Float3& b) {
      if (lower(a) != lower(b)) return lower(b);
      return cross(flat(a), flat(b)) > 0;
    });
    // The centre is inside only where no step turns by half a circle or more.
    bool around = true;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Float3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      around = around && cross(flat(a), flat(b)) > 0;
    }
    if (around) check_triangulation(polygon, Turn::left_or_straight);
  }
}

TEST_CASE("the plane of a polygon and its winding do not matter") {
  const Polygon arrow = {{0, 0, 0}, {4, 4, 0}, {0, 2, 0}, {-4, 4, 0}};
  const auto cut = triangulate(arrow);
  for (const int axis : {0, 1, 2}) {
    Polygon turned = arrow;
    for (Float3& p : turned) p = axis == 0 ? Float3(p.z, p.x, p.y) : axis == 1 ? Float3(p.y, p.z, p.x) : p;
    CHECK(triangulate(turned) == cut);
    std::reverse(turned.begin(), turned.end());
    CHECK(triangulate(turned).size() == 2);
    for (const auto& [a, b, c] : triangulate(turned)) {
      const Polygon triangle = {turned[a], turned[b], turned[c]};
      CHECK(dot(area_vector(triangle), area_vector(turned)) > 0);
    }
  }
}

TEST_CASE("polygons that cross themselves or have no area are cut into n - 2 triangles all the same") {
  CHECK(triangulate(Polygon{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size() == 2); // a bow tie
  CHECK(triangulate(Polygon(9, Float3(1, 2, 3))).size() == 7);
  CHECK(triangulate(Polygon{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 0, 0}}).size() == 3);
  const float huge = 3e38f;
  CHECK(triangulate(Polygon{{-huge, -huge, 0}, {huge, -huge, 0}, {huge, huge, 0}, {-huge, huge, 0}}).size() == 2);
}

TEST_CASE("a polygon that takes too many steps is refused, and the steps are spent") {
  Polygon folded;
  for (int i = 0; i < 1000; ++i) folded.push_back({static_cast<float>(i % 2), 0, 0}); // no ear anywhere
  std::uint64_t steps_left = 100000;
  CHECK(triangulate(folded, steps_left).empty());
  CHECK(steps_left == 0);
  steps_left = 10000000;
  CHECK(triangulate(folded, steps_left) == triangulate(folded));
  CHECK(steps_left > 0);
  CHECK(steps_left < 10000000);
  // What is simple costs nothing.
  const std::uint64_t before = steps_left;
  CHECK(triangulate(Polygon{{0, 0, 0}, {4, 4, 0}, {0, 2, 0}, {-4, 4, 0}}, steps_left).size() == 2);
  CHECK(steps_left == before);
}

} // namespace refraster::test
