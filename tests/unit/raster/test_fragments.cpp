// Between visibility and pixels: how what samples see becomes runs, packets and bytes.

#include "raster/resolve/rgb8.h"
#include "raster/shade/fragments.h"
#include "tests/support/for_all.h"
#include "tests/support/raster/triangles.h"
#include "tests/support/raster/window_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

using namespace refraster;
using namespace refraster::test;

namespace {

/// Large triangles, one over the other, and pixels that no triangle covers.
LatticeFrame some_triangles(Random& random, int side) {
  std::vector<std::array<WindowVertex, 3>> triangles;
  for (int count = 1 + random.below(12); count > 0; --count) {
    std::array<WindowVertex, 3> v;
    for (WindowVertex& corner : v)
      corner = lattice_vertex(random.below(side * subpixels), random.below(side * subpixels), random.uniform(-1, 1));
    triangles.push_back(v);
  }
  return LatticeFrame(triangles);
}

/// A pixel, what it sees, and with how many samples.
using Fragment = std::tuple<int, int, std::int32_t, int>;

/// In the order in which they are promised, found sample by sample.
std::vector<Fragment> fragments_of(const TileVisibility& visibility, int side, int samples) {
  std::vector<Fragment> fragments;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const std::size_t first = fragments.size();
      for (int s = 0; s < samples; ++s) {
        const std::int32_t slot = visibility.nearest(s, x, y);
        if (slot == nothing) continue;
        const auto same = std::find_if(fragments.begin() + static_cast<std::ptrdiff_t>(first), fragments.end(),
                                       [&](const Fragment& f) { return std::get<2>(f) == slot; });
        if (same == fragments.end()) fragments.emplace_back(x, y, slot, 1);
        else ++std::get<3>(*same);
      }
    }
  return fragments;
}

} // namespace

TEST_CASE("runs list each fragment once, in order, and are as long as neighbours see one triangle with all samples") {
  for_all(60, [](Random& random) {
    const int side = all_tile_sizes[random.below(5)], samples = 1 << random.below(5);
    CAPTURE(side);
    CAPTURE(samples);
    TileVisibility visibility(side);
    some_triangles(random, side).decide({0, 0, side, side}, samples, visibility);
    const std::vector<Fragment> expected = fragments_of(visibility, side, samples);
    std::vector<FragmentRun> runs(3); // of another tile
    list_runs(visibility, {0, 0, side, side}, samples, runs);

    std::vector<Fragment> listed;
    std::size_t fewest_runs = 0;
    for (const FragmentRun& run : runs)
      for (int i = 0; i < run.length; ++i) listed.emplace_back(run.x + i, run.y, run.slot, run.samples);
    REQUIRE(listed == expected);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const auto& [x, y, slot, seen] = expected[i];
      const bool goes_on = i > 0 && seen == samples && expected[i - 1] == Fragment{x - 1, y, slot, samples};
      fewest_runs += !goes_on;
    }
    CHECK(runs.size() == fewest_runs);
  });
}

TEST_CASE("a tile narrower than a register, or at the image's edge, has runs of its own pixels only") {
  for_all(40, [](Random& random) {
    const int side = all_tile_sizes[random.below(5)], samples = 1 << random.below(5);
    TileVisibility visibility(side);
    some_triangles(random, side).decide({0, 0, side, side}, samples, visibility);
    const PixelRect part{0, 0, 1 + random.below(side), 1 + random.below(side)};
    std::vector<FragmentRun> runs;
    list_runs(visibility, part, samples, runs);
    std::size_t listed = 0, expected = 0;
    for (const FragmentRun& run : runs) {
      REQUIRE(run.x + run.length <= part.width);
      REQUIRE(run.y < part.height);
      listed += run.length;
    }
    for (const auto& [x, y, slot, seen] : fragments_of(visibility, side, samples))
      expected += x < part.width && y < part.height;
    CHECK(listed == expected);
  });
}

TEST_CASE_TEMPLATE("packets hold the fragments of runs in order, and know what their lanes have in common", T,
                   FloatPrecision::Number, DoublePrecision::Number) {
  using Setup = AttributeSetup<RealOf<T>>;
  constexpr int lanes = NumberTraits<T>::lanes;
  const LargeEdges large{};
  for_all(200, [&](Random& random) {
    std::vector<Setup> triangles(3);
    for (Setup& triangle : triangles) triangle.large = random.below(4) == 0 ? &large : nullptr;
    PacketList<T> packets;
    struct Place {
      const Setup* triangle;
      std::int32_t x, y;
      bool operator==(const Place&) const = default;
    };
    std::vector<Place> expected;
    while (packets.room() > 0 && (expected.empty() || random.below(40) > 0)) {
      const Setup& triangle = triangles[static_cast<std::size_t>(random.below(3))];
      const int pixels = std::min(1 + random.below(random.below(2) == 0 ? 3 : 60), packets.room());
      const std::int32_t x = random.below(1 << 22), y = random.below(1 << 22);
      packets.add(triangle, x, y, pixels);
      for (int i = 0; i < pixels; ++i) expected.push_back({&triangle, x + i * subpixels, y});
    }
    REQUIRE(packets.fragments() == static_cast<int>(expected.size()));
    REQUIRE(packets.packets() == (packets.fragments() + lanes - 1) / lanes);
    for (int p = 0; p < packets.packets(); ++p) {
      const Packet<T> packet = packets.packet(p);
      REQUIRE(packet.count == std::min(lanes, packets.fragments() - p * lanes));
      bool one = true;
      EdgeKind edges = EdgeKind::wrapped;
      for (int lane = 0; lane < lanes; ++lane) {
        const Place& place = expected[static_cast<std::size_t>(p * lanes + std::min(lane, packet.count - 1))];
        REQUIRE(Place{&packet.triangle(lane), packet.x()[lane], packet.y()[lane]} == place);
        one = one && place.triangle == &packet.triangle(0);
        edges = std::max(edges, place.triangle->kind());
      }
      CHECK(packet.triangles == (one ? Triangles::one : Triangles::many));
      CHECK(packet.edges == edges);
    }
  });
}

TEST_CASE("pixels of three bytes are written as they are, and nothing beside them") {
  for_all(100, [](Random& random) {
    const int pixels = 1 + random.below(70);
    std::vector<std::int32_t> words;
    for (int i = 0; i < pixels + 4; ++i) words.push_back(random.below(1 << 24));
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(3 * pixels) + 8, 0xA5);
    store_rgb8(words.data(), pixels, bytes.data() + 4);
    std::vector<std::uint8_t> expected(4, 0xA5);
    for (int i = 0; i < pixels; ++i)
      for (int c = 0; c < 3; ++c)
        expected.push_back(static_cast<std::uint8_t>(words[static_cast<std::size_t>(i)] >> 8 * c));
    expected.insert(expected.end(), 4, 0xA5);
    REQUIRE(bytes == expected);
  });
}

TEST_CASE("what is known of a tile's depths hides a box just where all in it are nearer") {
  for_all(60, [](Random& random) {
    const int side = all_tile_sizes[random.below(5)];
    const auto samples = std::size_t{1} << random.below(3);
    const PixelRect tile{0, 0, 1 + random.below(side), 1 + random.below(side)};
    DepthTile depths(side);
    depths.clear(tile, samples);
    CHECK(!depths.is_occluded(0, 0, tile.width - 1, tile.height - 1, 0.9)); // nothing is known yet
    // Nearly everything is near, so that a box that is not hidden is so for a sample or two.
    for (std::size_t s = 0; s < samples; ++s)
      for (int y = 0; y < tile.height; ++y)
        for (int x = 0; x < tile.width; ++x)
          depths.depth_test_and_write(depths.at(static_cast<int>(s), x, y),
                                      random.below(200) == 0 ? random.uniform(-1, 1) : -0.75, 0);
    depths.refresh_bounds();
    for (int box = 0; box < 40; ++box) {
      const int left = random.below(tile.width), right = left + random.below(tile.width - left);
      const int top = random.below(tile.height), bottom = top + random.below(tile.height - top);
      const double z = random.uniform(-1, 1);
      // Bounds are of eight rows together.
      bool nearer = true;
      for (std::size_t s = 0; s < samples; ++s)
        for (int y = top & ~7; y < std::min((bottom | 7) + 1, tile.height); ++y)
          for (int x = left; x <= right; ++x) nearer = nearer && depths.depth(depths.at(static_cast<int>(s), x, y)) < z;
      REQUIRE(depths.is_occluded(left, top, right, bottom, z) == nearer);
    }
  });
}
