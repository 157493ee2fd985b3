// Triangles of a few pixels in 32-bit integers, against those of whole numbers.

#include "raster/visibility/tiny/tiny_triangles.h"
#include "tests/support/for_all.h"
#include "tests/support/raster/triangles.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>

using namespace refraster;
using namespace refraster::test;

namespace {

constexpr int lanes = 2 * NumberTraits<Native<double>>::lanes;
using Tiny = TinyTriangles<lanes>;
using Corners = std::array<WindowVertex, 3>;

// Anywhere in the guard band, of a subpixel, a pixel or two, or the greatest extent there may be; corners often at one
// x or y, on samples, at the near and the far plane.
Corners random_corners(Random& random) {
  constexpr std::int32_t reaches[] = {2, subpixels, 2 * subpixels, Tiny::max_extent};
  const std::int32_t reach = reaches[random.below(4)];
  const std::int32_t x0 = random.below(2 * guard_band - reach) - guard_band,
                     y0 = random.below(2 * guard_band - reach) - guard_band;
  const auto place = [&] { return random.below(8) == 0 ? random.below(2) * reach : random.below(reach + 1); };
  Corners v;
  for (WindowVertex& corner : v) {
    const std::int32_t x = x0 + place(), y = y0 + place();
    corner = lattice_vertex(x, y, random.below(4) == 0 ? random.uniform(-1.5, 1.5) : random.uniform(-1, 1));
    if (random.below(4) == 0) corner.x |= 128, corner.x &= ~127, corner.y |= 128, corner.y &= ~127;
  }
  if (random.below(4) == 0) v[1].x = v[0].x;
  if (random.below(4) == 0) v[2].y = v[static_cast<std::size_t>(random.below(2))].y;
  return v;
}

bool fits(const Corners& v) {
  const auto [x_min, x_max] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [y_min, y_max] = std::minmax({v[0].y, v[1].y, v[2].y});
  return std::max(x_max - x_min, y_max - y_min) <= Tiny::max_extent;
}

struct Gathered {
  Tiny::Ints x_sides[3], y_state[3];
  std::array<std::array<Native<double>, 2>, 3> z;

  explicit Gathered(const std::array<Corners, lanes>& triangles) {
    for (std::size_t k = 0; k < 3; ++k)
      for (int lane = 0; lane < lanes; ++lane) {
        const PlacedVertex v = PlacedVertex::of(triangles[static_cast<std::size_t>(lane)][k]);
        x_sides[k][lane] = v.x_sides, y_state[k][lane] = v.y_state;
        z[k][static_cast<std::size_t>(lane / (lanes / 2))].set(lane % (lanes / 2), v.z);
      }
  }
  Tiny triangles() const { return {x_sides, y_state}; }
};

bool fit(const std::array<Corners, lanes>& triangles) {
  return Gathered(triangles).triangles().fit;
}

std::array<Corners, lanes> random_register(Random& random) {
  std::array<Corners, lanes> result;
  for (Corners& v : result) do
      v = random_corners(random);
    while (!set_up_scalar(v) || !fits(v));
  return result;
}

} // namespace

TEST_CASE("tiny triangles cover the samples that whole numbers say, as deep as they are alone") {
  long covered = 0, on_edge = 0;
  for_all(5000, [&](Random& random) {
    const std::array<Corners, lanes> triangles = random_register(random);
    const Gathered gathered(triangles);
    const Tiny t = gathered.triangles();
    REQUIRE(t.fit);
    // A sample in the box or beside it, now and then on an edge that runs along a row or column of samples.
    Tiny::Ints x, y;
    for (int lane = 0; lane < lanes; ++lane) {
      const Corners& v = triangles[static_cast<std::size_t>(lane)];
      const auto near = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
        const std::int32_t least = std::min({a, b, c}), greatest = std::max({a, b, c});
        const std::int32_t at = least + random.below(greatest - least + 1);
        return random.below(2) == 0 ? a : std::max(at - random.below(2 * subpixels), least - 1023);
      };
      x[lane] = near(v[0].x, v[1].x, v[2].x), y[lane] = near(v[1].y, v[2].y, v[0].y);
    }
    const TinyCoverage<lanes> coverage = cover_tiny<lanes>(t, gathered.z, x, y);
    for (int lane = 0; lane < lanes; ++lane) {
      const Corners& v = triangles[static_cast<std::size_t>(lane)];
      const ScalarTriangle expected = set_up_scalar(v).value();
      for (int i = 0; i < 4; ++i) {
        const std::int32_t sx = x[lane] + (i & 1) * subpixels, sy = y[lane] + (i >> 1) * subpixels;
        bool inside = true;
        for (std::size_t k = 0; k < 3; ++k) {
          const std::int64_t e = expected.at(k, sx, sy);
          const SnappedEdge edge{expected.a[k], expected.b[k], 0};
          on_edge += e == 0;
          inside = inside && (e > 0 || (e == 0 && edge.owns_ties()));
        }
        const double z = expected.depth(sx, sy);
        const bool drawn = z >= -1 && z < beyond_far;
        REQUIRE((coverage.lanes[static_cast<std::size_t>(i)] >> lane & 1) == (inside && drawn));
        covered += inside && drawn;
        constexpr int half = lanes / 2;
        REQUIRE(coverage.z[static_cast<std::size_t>(i)][static_cast<std::size_t>(lane / half)][lane % half] == z);
      }
    }
  });
  CHECK(covered > 1250L * lanes);
  CHECK(on_edge > 10000);
}

TEST_CASE("a register that holds a larger triangle, or a corner off the lattice, does not fit") {
  for_all(300, [](Random& random) {
    std::array<Corners, lanes> triangles = random_register(random);
    REQUIRE(fit(triangles));
    Corners& v = triangles[static_cast<std::size_t>(random.below(lanes))];
    WindowVertex& corner = v[static_cast<std::size_t>(random.below(3))];
    switch (random.below(4)) {
    case 0:
      corner.outcode |= outcode::unsnapped;
      break;
    case 1:
      corner.outcode |= outcode::not_finite;
      break;
    case 2:
      v = {lattice_vertex(-5, 7), lattice_vertex(-5 + Tiny::max_extent + 1, 7), lattice_vertex(0, 9)};
      break;
    case 3:
      v = {lattice_vertex(1, -guard_band), lattice_vertex(2, guard_band), lattice_vertex(3, 0)};
      break;
    }
    CHECK_FALSE(fit(triangles));
  });
}

TEST_CASE("what is seen does not depend on how triangles share registers with larger ones") {
  constexpr PixelRect tile{64, 128, 32, 32};
  for_all(200, [&](Random& random) {
    std::vector<Corners> tiny;
    const auto corner = [&](std::int32_t x, std::int32_t y, std::int32_t reach) {
      return lattice_vertex(x + random.below(reach), y + random.below(reach), random.uniform(-1.1, 1.1));
    };
    for (int i = 0; i < 300; ++i) {
      const std::int32_t x = (tile.x - 2 + random.below(tile.width + 4)) * subpixels,
                         y = (tile.y - 2 + random.below(tile.height + 4)) * subpixels;
      const std::int32_t reach = random.below(4) == 0 ? 6 * subpixels : 2 * subpixels;
      tiny.push_back({corner(x, y, reach), corner(x, y, reach), corner(x, y, reach)});
    }
    // The same with one in each register that does not fit, and covers no sample of the tile.
    std::vector<Corners> mixed;
    std::vector<std::int64_t> number_of;
    for (std::size_t i = 0; i < tiny.size(); ++i) {
      if (i % 3 == 0)
        mixed.push_back({lattice_vertex(0, 0), lattice_vertex(0, 60000), lattice_vertex(500, 60000)}),
            number_of.push_back(-1);
      mixed.push_back(tiny[i]), number_of.push_back(static_cast<std::int64_t>(i));
    }
    TileVisibility alone(tile.width), among(tile.width);
    LatticeFrame(tiny).decide(tile, 1, alone);
    LatticeFrame(mixed).decide(tile, 1, among);
    long wrong = 0;
    for (int y = 0; y < tile.height; ++y)
      for (int x = 0; x < tile.width; ++x) {
        const std::int64_t a = seen_triangle(alone, 0, x, y), b = seen_triangle(among, 0, x, y);
        wrong += a != (b < 0 ? -1 : number_of[static_cast<std::size_t>(b)]);
        if (a >= 0) wrong += alone.depth(0, x, y) != among.depth(0, x, y);
      }
    CHECK(wrong == 0);
  });
}
