#include "tests/support/raster/oracle.h"
#include "tests/support/raster/triangles.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using namespace refraster;
using namespace refraster::test;

namespace {

using Corners = std::array<LatticePoint, 3>;

std::array<WindowVertex, 3> window(const Corners& c) {
  const auto vertex = [](LatticePoint p) {
    return lattice_vertex(static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y));
  };
  return {vertex(c[0]), vertex(c[1]), vertex(c[2])};
}

bool has_area(const Corners& c) {
  return (c[1].x - c[0].x) * (c[2].y - c[0].y) != (c[2].x - c[0].x) * (c[1].y - c[0].y);
}

// Samples of an n x n tile at which the pipeline and the oracle disagree, for one triangle.
template <int bits>
int mismatches(const Corners& corners, int n, TileVisibility& visibility) {
  const LatticeFrame frame({window(corners)});
  frame.decide({0, 0, n, n}, 1, visibility);
  int wrong = 0;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const bool expected = oracle_covers<Int128, bits>(corners, {x * 256 + 128, y * 256 + 128});
      wrong += (visibility.nearest(0, x, y) != nothing) != expected;
    }
  return wrong;
}

// Every triangle with corners on the half-pixel lattice of an 8 x 8 field, or one in `stride` of them; each once, with
// its corners in one of the six orders.
void lattice(std::size_t stride) {
  constexpr int side = 17;
  std::vector<LatticePoint> points;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) points.push_back({x * 128, y * 128});
  TileVisibility visibility(8);
  std::size_t seen = 0, tested = 0;
  long wrong = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        if (seen++ % stride != 0) continue;
        Corners corners{points[i], points[j], points[k]};
        if (!has_area(corners)) continue;
        for (std::size_t turn = 0; turn < seen % 6; ++turn)
          std::next_permutation(corners.begin(), corners.end(),
                                [](auto& p, auto& q) { return p.y != q.y ? p.y < q.y : p.x < q.x; });
        wrong += mismatches<12>(corners, 8, visibility);
        ++tested;
      }
  MESSAGE("lattice triangles: " << tested << ", samples: " << tested * 64 << ", mismatches: " << wrong);
  CHECK(wrong == 0);
}

// Triangles at any subpixel around a 16 x 16 tile; a third of them slivers, a third with corners on sample centres.
Corners random_triangle(std::mt19937_64& random) {
  const auto coordinate = [&](int low, int high) {
    return static_cast<std::int64_t>(std::uniform_int_distribution(low, high)(random));
  };
  Corners c;
  const int kind = static_cast<int>(random() % 3);
  for (LatticePoint& p : c) {
    p = {coordinate(-2000, 6000), coordinate(-2000, 6000)};
    if (kind == 1) p = {(p.x & ~255) + 128, (p.y & ~255) + 128};
  }
  if (kind == 2) c[2] = {(c[0].x + c[1].x) / 2 + coordinate(-3, 3), (c[0].y + c[1].y) / 2 + coordinate(-3, 3)};
  return c;
}

void random_triangles(int count) {
  std::mt19937_64 random(1);
  TileVisibility visibility(16);
  long wrong = 0;
  for (int i = 0; i < count; ++i) {
    const Corners corners = random_triangle(random);
    if (has_area(corners)) wrong += mismatches<14>(corners, 16, visibility);
  }
  MESSAGE("random triangles: " << count << ", samples: " << count * 256L << ", mismatches: " << wrong);
  CHECK(wrong == 0);
}

} // namespace

TEST_CASE("coverage agrees with exact ray crossings for triangles on the half-pixel lattice: one in 101") {
  lattice(101);
}
TEST_CASE("coverage agrees with exact ray crossings for random triangles, slivers and corners on samples") {
  random_triangles(20'000);
}

TEST_CASE("coverage is exact up to the guard band and past it") {
  using Integer = boost::multiprecision::int1024_t;
  std::mt19937_64 random(2);
  long samples = 0, wrong = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    // Corners from a few pixels to 2^28 subpixels away, in an image of 16384 x 16384 pixels. The clip coordinates are
    // chosen so that the window point is that lattice point exactly: w = 1, x = X / 2^21 - 1.
    const int reach = 12 + trial % 17;
    std::array<LatticePoint, 3> corners;
    std::array<Double4, 3> clip;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t span = std::int64_t{1} << reach;
      corners[k] = {static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * span)) - span + (1 << 21),
                    static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * span)) - span + (1 << 21)};
      clip[k] = {static_cast<double>(corners[k].x) / (1 << 21) - 1, 1 - static_cast<double>(corners[k].y) / (1 << 21),
                 0, 1};
    }
    const auto triangle = set_up(clip, 16384, 16384);
    if (!has_area(corners)) {
      CHECK(!triangle);
      continue;
    }
    REQUIRE(triangle);
    // Samples near points of the edges, where it matters.
    for (int i = 0; i < 30; ++i) {
      const LatticePoint &p = corners[static_cast<std::size_t>(i % 3)],
                         &q = corners[static_cast<std::size_t>((i + 1) % 3)];
      const double t = static_cast<double>(random() % 1024) / 1024;
      const auto near = [&](std::int64_t a, std::int64_t b) {
        const double at = static_cast<double>(a) + t * static_cast<double>(b - a);
        const auto pixel = static_cast<std::int64_t>(std::clamp(at, 0.0, 4194303.0)) >> 8;
        return std::clamp<std::int64_t>(pixel + static_cast<std::int64_t>(random() % 3) - 1, 0, 16383) * 256 + 128;
      };
      const LatticePoint sample{near(p.x, q.x), near(p.y, q.y)};
      const bool expected = oracle_covers<Integer, 30>(corners, sample);
      wrong += triangle->covers(static_cast<std::int32_t>(sample.x), static_cast<std::int32_t>(sample.y)) != expected;
      ++samples;
    }
  }
  MESSAGE("samples near edges: " << samples << ", mismatches: " << wrong);
  CHECK(wrong == 0);
}

TEST_CASE("64-bit and projective set-up name the same samples") {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 2000; ++trial) {
    const Corners corners = random_triangle(random);
    const auto v = window(corners);
    const auto narrow = set_up_on_lattice(v);
    const auto wide = set_up_projective(v, {}, {16, 16, 1}); // clip coordinates matter to unsnapped vertices only
    REQUIRE(narrow.has_value() == wide.has_value());
    if (!narrow) continue;
    CHECK(narrow->scalar.facing == wide->facing);
    const AnyTriangle &a = *narrow, b{*wide};
    for (int y = 128; y < 4096; y += 256)
      for (int x = 128; x < 4096; x += 256) REQUIRE(a.covers(x, y) == b.covers(x, y));
  }
}

TEST_SUITE("slow") {
  TEST_CASE("coverage agrees with exact ray crossings for every triangle on the half-pixel lattice") {
    lattice(1);
  }
  TEST_CASE("coverage agrees with exact ray crossings for a million random triangles") {
    random_triangles(1'000'000);
  }
}
