#include "tests/support/for_all.h"
#include "tests/support/raster/triangles.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace refraster;
using namespace refraster::test;

namespace {

using Corners = std::array<WindowVertex, 3>;
constexpr int side = 16;

/// Large enough for any tile here, at one depth: to the last bit, since nothing is added to it.
Corners backdrop(double z) {
  return {lattice_vertex(-9999, -9999, z), lattice_vertex(-9999, 99999, z), lattice_vertex(99999, -9999, z)};
}

/// At how many samples the triangle numbered `which` is the nearest.
int seen(const std::vector<Corners>& triangles, std::uint32_t which, TileVisibility& visibility) {
  const LatticeFrame frame(triangles);
  frame.decide({0, 0, side, side}, 1, visibility);
  int count = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) count += seen_triangle(visibility, 0, x, y) == which;
  return count;
}

} // namespace

TEST_CASE("no sample of a triangle lies before its nearest corner or behind its farthest, not by a bit") {
  TileVisibility visibility(side);
  for (const int extent : {side, 2}) { // pixels; small triangles go a way of their own
    CAPTURE(extent);
    int covered = 0;
    for_all(3000, [&](Random& random) {
      // Corners on sample centres, where depth is a corner's own but for rounding. One that the triangle owns, since a
      // top edge and a left edge meet there, and which is not the leftmost, where depths are counted from.
      const auto distance = [&] { return 1 + static_cast<std::int32_t>(random.uniform(0, 0.4 * extent) * subpixels); };
      const std::int32_t own_x = extent / 2 * subpixels + 128, own_y = (extent / 2 - 1) * subpixels + 128;
      Corners corners{lattice_vertex(own_x, own_y, random.uniform(-1, 1)),
                      lattice_vertex(own_x + distance(), own_y, random.uniform(-1, 1)),
                      lattice_vertex(own_x - distance(), own_y + distance(), random.uniform(-1, 1))};
      if (random.uniform(0, 1) < 0.5)
        for (WindowVertex& v : corners) {
          const auto place = [&] { return static_cast<std::int32_t>(random.uniform(0, extent)) * subpixels + 128; };
          const std::int32_t x = place(), y = place();
          v = lattice_vertex(x, y, v.z);
        }
      if (!set_up_snapped(corners)) return;
      const double z_min = std::min({corners[0].z, corners[1].z, corners[2].z});
      const double z_max = std::max({corners[0].z, corners[1].z, corners[2].z});
      // Of equal depths the first drawn is seen: so never the triangle before this, and never this before the triangle.
      const int own = seen({corners}, 0, visibility);
      covered += own;
      REQUIRE(seen({backdrop(z_min), corners}, 1, visibility) == 0);
      REQUIRE(seen({corners, backdrop(z_max)}, 0, visibility) == own);
    });
    CHECK(covered > (extent == side ? 10'000 : 1000));
  }
}
