// How a frame is divided among many threads, by counts and not by times: pieces of work, the largest of them, bytes
// that are written. So it can be shown on a machine with two cores. `test_raster -s -tc="*threads*"` prints the counts.

#include <refraster/mesh.h>

#include "math/precisions.h"
#include "raster/tile_order.h"
#include "raster/visibility/runs.h"
#include "tests/support/for_all.h"
#include "tests/support/raster/binned_geometry.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <vector>

using namespace refraster;

namespace {

constexpr int thread_counts[] = {8, 16, 32, 64};

// A ball of 2 n (n - 1) triangles in the middle of the image.
Scene ball(int n) {
  Scene scene;
  scene.camera.position = {0, 0, 4};
  Object object;
  object.mesh = std::make_shared<const Mesh>(sphere_mesh(n, n));
  scene.objects.push_back(object);
  return scene;
}

RenderOptions options_of(int width, int height, int threads) {
  RenderOptions options;
  options.width = width, options.height = height, options.threads = threads;
  return options;
}

std::vector<std::uint64_t> sizes_of(const std::vector<std::vector<RunPart>>& runs) {
  std::vector<std::uint64_t> sizes;
  for (const std::vector<RunPart>& parts : runs) {
    sizes.push_back(0);
    for (const RunPart& part : parts) sizes.back() += part.end - part.begin;
  }
  return sizes;
}

/// When the last of so many threads is done, if each takes the next piece as soon as it is free.
std::uint64_t makespan(const std::vector<std::uint64_t>& pieces, int threads) {
  std::vector<std::uint64_t> busy(static_cast<std::size_t>(threads));
  for (const std::uint64_t piece : pieces) *std::min_element(busy.begin(), busy.end()) += piece;
  return *std::max_element(busy.begin(), busy.end());
}

std::uint64_t sum(const std::vector<std::uint64_t>& pieces) {
  return std::accumulate(pieces.begin(), pieces.end(), std::uint64_t{0});
}

} // namespace

TEST_CASE("a small mesh is binned by many threads: runs of at least 512 triangles, two for each thread or more") {
  const Scene scene = ball(128);
  for (const int threads : thread_counts) {
    const FrameInput input{scene, options_of(1280, 720, threads)};
    Geometry geometry;
    lay_out(input, geometry);
    const std::vector<std::uint64_t> runs = sizes_of(runs_of(geometry, threads));
    REQUIRE(sum(runs) == geometry.triangles());
    const std::uint64_t largest = *std::max_element(runs.begin(), runs.end()), all = sum(runs);
    const double speedup = static_cast<double>(all) / static_cast<double>(makespan(runs, threads));
    MESSAGE("bin, ", all, " triangles, ", threads, " threads: ", runs.size(), " runs, at most ", largest,
            " triangles, at best ", speedup, " times as fast as one thread");
    CHECK(runs.size() == std::min<std::size_t>(all / 512, static_cast<std::size_t>(threads) * 4));
    CHECK(largest <= all / runs.size() + 1);
    CHECK(speedup >= 0.9 * std::min<double>(threads, static_cast<double>(runs.size())));
  }
}

TEST_CASE("vertices are transformed by many threads, whatever their number") {
  for (const std::size_t vertices : {std::size_t{1}, std::size_t{2049}, std::size_t{16641}, std::size_t{501501}})
    for (const int threads : thread_counts) {
      const std::size_t piece = vertex_piece(vertices, threads), pieces = (vertices + piece - 1) / piece;
      MESSAGE("transform, ", vertices, " vertices, ", threads, " threads: ", pieces, " pieces of at most ", piece);
      CHECK(piece % NumberTraits<Native<double>>::lanes == 0);
      CHECK(pieces >= std::min<std::size_t>(vertices / 256, static_cast<std::size_t>(threads) * 4));
    }
}

TEST_CASE("lists of a large image take what is listed and a little a run, whatever the number of threads") {
  const Scene scene = ball(256);
  std::size_t of_one = 0;
  for (const int threads : {1, 8, 16, 32, 64}) {
    const FrameInput input{scene, options_of(8192, 8192, threads)};
    const BinnedGeometry binned(input);
    const TileGrid grid = tile_grid(input);
    std::size_t entries = 0;
    for (const std::uint32_t size : binned.bins.lists.sizes(grid.tiles())) entries += size;
    const std::size_t bytes = binned.bins.lists.bytes(), runs = runs_of(binned.geometry, threads).size();
    MESSAGE("lists, ", grid.tiles(), " tiles, ", threads, " threads: ", runs, " runs, ", entries, " entries, ", bytes,
            " bytes");
    if (threads == 1) of_one = bytes;
    // A list head for each run and tile would be 32 bytes.
    CHECK(bytes < of_one + runs * grid.tiles() * 4);
  }
}

TEST_CASE("with several threads no tile that has much to draw is begun last") {
  // Small against the image: most tiles are empty.
  const Scene scene = ball(400);
  for (const int threads : thread_counts) {
    const FrameInput input{scene, options_of(1280, 720, threads)};
    const BinnedGeometry binned(input);
    const TileGrid grid = tile_grid(input);
    const TileLists& lists = binned.bins.lists;
    const std::vector<std::uint32_t> order = tile_order(grid, lists, threads), rows = tile_order(grid, lists, 1);
    std::vector<std::uint32_t> sorted = order;
    std::sort(sorted.begin(), sorted.end());
    REQUIRE(sorted == rows);
    const std::vector<std::uint32_t> sizes = lists.sizes(grid.tiles());
    const auto work_of = [&](const std::vector<std::uint32_t>& tiles) {
      std::vector<std::uint64_t> work;
      for (const std::uint32_t tile : tiles) {
        const PixelRect pixels = grid.tile(tile);
        const std::uint32_t entries = sizes[tile];
        work.push_back(entries == 0 ? 1 : entries + static_cast<std::uint64_t>(pixels.width * pixels.height));
      }
      return work;
    };
    const std::vector<std::uint64_t> by_work = work_of(order), by_row = work_of(rows);
    const std::uint64_t last = makespan(by_work, threads), all = sum(by_work);
    MESSAGE("tiles, ", threads, " threads: ", order.size(), " tiles, the largest ",
            *std::max_element(by_row.begin(), by_row.end()), " of ", all,
            " pixels and entries; the last thread is done after ", last, ", row by row after ",
            makespan(by_row, threads));
    CHECK(last <= makespan(by_row, threads));
    for (std::size_t i = 1; i < by_work.size(); ++i) CHECK(by_work[i] < 2 * by_work[i - 1]);
  }
}

TEST_CASE("a tile's list is what runs add to it, in their order, also in memory that was used before") {
  for_all(60, [](Random& random) {
    TileLists lists;
    for (int frame = 0; frame < 4; ++frame) {
      const auto runs = static_cast<std::size_t>(1 + random.below(9)),
                 tiles = static_cast<std::size_t>(1 + random.below(300));
      lists.reset(runs, tiles);
      std::vector<std::vector<std::uint32_t>> expected(tiles);
      std::uint32_t number = 0;
      for (std::size_t run = 0; run < runs; ++run) {
        const int entries = random.below(3) == 0 ? 0 : random.below(3000);
        const bool narrow = random.below(2) == 0; // all to few tiles
        for (int i = 0; i < entries; ++i) {
          const std::size_t tile =
              static_cast<std::size_t>(random.below(narrow ? 1 + random.below(2) : static_cast<int>(tiles))) % tiles;
          lists.run(run).add(tile, TileEntry::projective(number));
          expected[tile].push_back(number++);
        }
      }
      const std::vector<std::uint32_t> sizes = lists.sizes(tiles);
      for (std::size_t tile = 0; tile < tiles; ++tile) {
        std::vector<std::uint32_t> found;
        lists.for_each_piece(tile, [&](std::span<const TileEntry> piece) {
          for (const TileEntry& entry : piece) found.push_back(entry.triangle);
        });
        REQUIRE(found == expected[tile]);
        REQUIRE(sizes[tile] == found.size());
      }
      CHECK(lists.bytes() >= number * sizeof(TileEntry));
    }
  });
}
