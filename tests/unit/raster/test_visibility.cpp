// Whole frames of triangles of all sizes, through every way that binning and tiles have for them, against one triangle
// and one sample at a time.

#include "raster/visibility/draw_projective.h"
#include "tests/support/for_all.h"
#include "tests/support/raster/oracle.h"
#include "tests/support/raster/triangles.h"
#include "tests/support/raster/window_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>

using namespace refraster;
using namespace refraster::test;

namespace {

struct Seen {
  std::int64_t triangle = -1;
  double z = 0;
  bool operator==(const Seen& other) const {
    return triangle == other.triangle &&
           (triangle < 0 || std::bit_cast<std::uint64_t>(z) == std::bit_cast<std::uint64_t>(other.z));
  }
};

// covers(triangle, x, y) and depth(triangle, x, y) at a sample, in subpixels.
template <class Covers, class Depth>
Seen nearest_of(std::size_t triangles, std::int32_t x, std::int32_t y, const Covers& covers, const Depth& depth) {
  Seen seen{-1, 2};
  for (std::size_t t = 0; t < triangles; ++t) {
    if (!covers(t, x, y)) continue;
    const double z = depth(t, x, y);
    if (z >= -1 && z <= 1 && z < seen.z) seen = {static_cast<std::int64_t>(t), z};
  }
  return seen;
}

/// How many samples of the region see something else than they should, for tiles of one size.
template <class Expected>
long wrong_samples(const Scene& scene, const Geometry& geometry, const PixelRect& region, int image_side, int tile_size,
                   int sample_count, int threads, const Expected& expected) {
  RenderOptions options;
  options.width = options.height = image_side;
  options.crop = {region};
  options.samples = sample_count, options.threads = threads, options.tile_size = tile_size;
  Bins bins;
  FrameCounts counts;
  const FrameContext context{{scene, options}, geometry, bins};
  bin_triangles(context, geometry, bins, counts);
  const TileGrid grid = tile_grid(context);
  TileVisibility visibility(tile_size);
  long wrong = 0;
  for (std::size_t i = 0; i < grid.tiles(); ++i) {
    const PixelRect tile = grid.tile(i);
    visibility.decide(context, i, tile);
    for (int s = 0; s < sample_count; ++s)
      for (int y = 0; y < tile.height; ++y)
        for (int x = 0; x < tile.width; ++x) {
          const auto place = static_cast<std::size_t>(s);
          const Seen got{seen_triangle(visibility, s, x, y), visibility.depth(s, x, y)};
          wrong += !(got == expected((tile.x + x) * subpixels + context.samples[place].x,
                                     (tile.y + y) * subpixels + context.samples[place].y));
        }
    const auto listed = visibility.triangles();
    wrong += std::adjacent_find(listed.begin(), listed.end(), std::greater_equal<>()) != listed.end();
  }
  return wrong;
}

// Nearly all are small, as in meshes: of a pixel or two, of a few, of some dozens; a few reach beyond the image, or to
// the ends of the guard band. Depths are often equal, for many triangles and samples.
std::vector<std::array<WindowVertex, 3>> mixed_triangles(Random& random, int count) {
  std::vector<std::array<WindowVertex, 3>> result;
  while (static_cast<int>(result.size()) < count) {
    constexpr int sizes[] = {1, 2, 3, 5, 9, 20, 60, 500, 120'000};
    const int size = sizes[random.below(random.below(9) + 1)] * subpixels;
    const int x = random.below(120 * subpixels), y = random.below(90 * subpixels);
    const bool level = random.below(3) == 0, on_samples = random.below(4) == 0;
    const double level_z = random.below(5) / 2.0 - 1;
    std::array<WindowVertex, 3> v;
    std::array<LatticePoint, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto place = [&](int middle) {
        return std::clamp(middle + random.below(size + 1) - size / 2, -guard_band, guard_band);
      };
      int px = place(x), py = place(y);
      if (on_samples) px = (px & ~255) + 128, py = (py & ~255) + 128;
      const double z = random.below(9) == 0 ? random.uniform(-3, 3) : random.uniform(-1, 1);
      v[k] = lattice_vertex(px, py, level ? level_z : z);
      p[k] = {px, py};
    }
    result.push_back(v);
    if (random.below(4) == 0) result.push_back({v[1], v[2], v[0]}); // the same again
  }
  return result;
}

void mixed_frame(std::uint64_t seed, int triangles) {
  Random random(seed);
  const auto vertices = mixed_triangles(random, triangles);
  const LatticeFrame frame(vertices);
  std::vector<std::optional<ScalarTriangle>> set_up;
  std::vector<std::array<LatticePoint, 3>> corners;
  for (const auto& v : vertices) {
    set_up.push_back(set_up_scalar(v));
    corners.push_back({LatticePoint{v[0].x, v[0].y}, {v[1].x, v[1].y}, {v[2].x, v[2].y}});
  }
  const auto covers = [&](std::size_t t, std::int32_t x, std::int32_t y) {
    return set_up[t] && x >= set_up[t]->x_min && x <= set_up[t]->x_max && y >= set_up[t]->y_min &&
           y <= set_up[t]->y_max && oracle_covers<Int128, 25>(corners[t], {x, y});
  };
  const auto depth = [&](std::size_t t, std::int32_t x, std::int32_t y) { return set_up[t]->depth(x, y); };
  const PixelRect region{random.below(20), random.below(20), 40 + random.below(60), 30 + random.below(40)};
  const int samples = 1 << random.below(5);
  // Each sample's answer once, for all tile sizes.
  const auto pattern = sample_pattern(samples);
  std::vector<Seen> answers;
  const auto place = [&](std::int32_t x, std::int32_t y) { // samples of a pixel differ in place
    const int px = (x >> 8) - region.x, py = (y >> 8) - region.y;
    const auto s = std::find_if(pattern.begin(), pattern.end(),
                                [&](const SamplePosition& p) { return p.x == (x & 255) && p.y == (y & 255); });
    return static_cast<std::size_t>((py * region.width + px) * samples + static_cast<int>(s - pattern.begin()));
  };
  for (int y = 0; y < region.height; ++y)
    for (int x = 0; x < region.width; ++x)
      for (const SamplePosition& s : pattern)
        answers.push_back(nearest_of(vertices.size(), (region.x + x) * subpixels + s.x,
                                     (region.y + y) * subpixels + s.y, covers, depth));
  for (const int tile_size : all_tile_sizes) {
    CAPTURE(tile_size);
    CAPTURE(samples);
    CHECK(wrong_samples(frame.scene, frame.geometry, region, 128, tile_size, samples, 1 + tile_size / 16 % 3,
                        [&](std::int32_t x, std::int32_t y) { return answers[place(x, y)]; }) == 0);
  }
}

} // namespace

TEST_CASE("each sample sees the nearest of triangles of all sizes, of equals the first") {
  for_all(40, [](Random& random) { mixed_frame(random.bits(), 1 << random.below(10)); });
}

TEST_CASE("triangles that reach behind the eye see and are seen as one sample at a time") {
  for_all(60, [](Random& random) {
    const int side = 64;
    WindowScene window(side, 0.25, 64);
    const int triangles = 1 + random.below(12);
    const auto corner = [&] {
      const double reach = random.below(3) == 0 ? 1e5 : 4;
      const auto c = [&] { return static_cast<float>(random.uniform(-reach, reach)); };
      const float x = c(), y = c(), z = c();
      return Float3(x, y, z);
    };
    for (int t = 0; t < triangles; ++t) {
      const Float3 a = corner(), b = corner(), c = corner();
      window.add({a, b, c});
      if (random.below(3) == 0) window.add({b, c, a});
    }
    Geometry geometry;
    RenderOptions options;
    options.width = options.height = side, options.threads = 1;
    transform({window.scene, options}, geometry);
    std::vector<std::optional<AnyTriangle>> set_up;
    for (const Object& object : window.scene.objects) {
      const auto& p = object.mesh->positions;
      set_up.push_back(test::set_up({window.clip(p[0]), window.clip(p[1]), window.clip(p[2])}, side, side,
                                    window.scene.camera.near));
    }
    const auto covers = [&](std::size_t t, std::int32_t x, std::int32_t y) {
      return set_up[t] && set_up[t]->covers(x, y);
    };
    const auto depth = [&](std::size_t t, std::int32_t x, std::int32_t y) { return set_up[t]->depth(x, y); };
    const int samples = 1 << random.below(5);
    for (const int tile_size : {8, 64})
      CHECK(wrong_samples(
                window.scene, geometry, {5, 3, 50, 60}, side, tile_size, samples, 1,
                [&](std::int32_t x, std::int32_t y) { return nearest_of(set_up.size(), x, y, covers, depth); }) == 0);
  });
}

TEST_CASE("a triangle is not hidden by what is as near and drawn before it, but comes later in the scene") {
  // The second triangle covers the tile, and its depth grows by columns, exactly. It begins nearer than the first, so
  // that it is drawn before it. The first lies at one depth: that of the second at the last column it covers.
  constexpr int side = 16, last_column = 7;
  constexpr std::int32_t start = -(1 << 14), length = 1 << 16;
  constexpr std::int32_t sample = last_column * subpixels + 128;
  const double z = static_cast<double>(sample - start) / (2 * length);
  const std::vector<std::array<WindowVertex, 3>> triangles = {
      {lattice_vertex(0, -length, z), lattice_vertex(0, length, z), lattice_vertex(sample + 120, 8 * subpixels, z)},
      {lattice_vertex(start, start, 0), lattice_vertex(start, start + length, 0),
       lattice_vertex(start + length, start, 0.5)}};
  TileVisibility visibility(side);
  LatticeFrame(triangles).decide({0, 0, side, side}, 1, visibility);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      CAPTURE(x);
      CAPTURE(y);
      REQUIRE(seen_triangle(visibility, 0, x, y) == (x == last_column ? 0 : 1));
    }
}

TEST_CASE("behind the eye, depths come from edge values that are rounded once, however many bits they have") {
  // One line as large as can be, with a value at one sample that lies next to the middle between two doubles; the
  // others make its value the depth.
  constexpr int side = 128;
  const PixelRect tile{0, 0, side, side};
  DepthTile depths(side);
  for_all(200, [&](Random& random) {
    const std::int32_t column = 64 + static_cast<std::int32_t>(random.below(64));
    const std::int32_t x = column * subpixels + 128, y = 128;
    const auto half_a_place = Int128{1} << 56; // of numbers from 2^109 to 2^110
    const auto places = static_cast<Int128>(random.uniform(0x1p52, 0x1.8p52));
    const Int128 value = 2 * half_a_place * places + half_a_place + static_cast<Int128>(random.below(80)) - 40;
    ProjectiveTriangle triangle;
    triangle.pieces = 1;
    ProjectivePiece& piece = triangle.piece[0];
    ProjectiveEdge& line = piece.edge[0];
    line.a = static_cast<std::int64_t>(random.uniform(-0x1p60, 0x1p60)) | 1;
    line.b = static_cast<std::int64_t>(random.uniform(-0x1p60, 0x1p60)) | 1;
    line.c = value - static_cast<Int128>(line.a) * x - static_cast<Int128>(line.b) * y;
    piece.edge[1].c = piece.edge[2].c = 1;
    piece.weight = {0x1p-110, 1, 1}, piece.z = {1, 0, 0}, piece.w = {0, 1, 0};

    depths.clear(tile, 1);
    draw_projective(triangle, 0, tile, sample_pattern(1), depths);
    for (const std::int32_t at : {column - 1, column, column + 1}) {
      const std::size_t sample = depths.at(0, std::min(at, side - 1), 0);
      REQUIRE(depths.nearest(sample) == 0);
      REQUIRE(depths.depth(sample) == piece.depth(std::min(at, side - 1) * subpixels + 128, y));
    }
  });
}

TEST_CASE("behind the eye, the samples that are drawn are those that the edges cover, wherever the lines run") {
  // Lines through a sample of the tile, or a value beside it, with slopes of all sizes: among them level and upright
  // ones.
  DepthTile depths(128);
  for_all(400, [&](Random& random) {
    const PixelRect tile{static_cast<int>(random.below(3)) * 128, static_cast<int>(random.below(3)) * 128,
                         1 + static_cast<int>(random.below(128)), 1 + static_cast<int>(random.below(128))};
    const auto slope = [&] {
      const double size = random.below(8) == 0
                              ? 0
                              : random.uniform(0x1p-1, 1) * static_cast<double>(std::int64_t{1} << random.below(61));
      return static_cast<std::int64_t>(random.below(2) == 0 ? size : -size);
    };
    const auto sample_at = [](int first, int pixel) { return (first + pixel) * subpixels + 128; };
    ProjectiveTriangle triangle;
    triangle.pieces = 1;
    ProjectivePiece& piece = triangle.piece[0];
    for (ProjectiveEdge& line : piece.edge) {
      line.a = slope(), line.b = slope();
      const std::int32_t x = sample_at(tile.x, random.below(tile.width)),
                         y = sample_at(tile.y, random.below(tile.height));
      line.c =
          static_cast<Int128>(random.below(5)) - 2 - static_cast<Int128>(line.a) * x - static_cast<Int128>(line.b) * y;
    }
    piece.weight = piece.w = {1, 1, 1};
    depths.clear(tile, 1);
    draw_projective(triangle, 0, tile, sample_pattern(1), depths);
    for (int y = 0; y < tile.height; ++y)
      for (int x = 0; x < tile.width; ++x) {
        const bool covers = piece.covers(sample_at(tile.x, x), sample_at(tile.y, y));
        const bool is_drawn = depths.nearest(depths.at(0, x, y)) == 0;
        CAPTURE(x);
        CAPTURE(y);
        REQUIRE(is_drawn == covers);
      }
  });
}
