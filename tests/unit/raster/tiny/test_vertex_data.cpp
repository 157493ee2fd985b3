// What is interpolated straight from vertices, against records of the same triangles: bit for bit.

#include "raster/shade/tiny/tiny_surface.h"
#include "tests/support/for_all.h"
#include "tests/support/raster/binned_geometry.h"
#include "tests/support/scenes/random_scene.h"

#include <doctest/doctest.h>

#include <cstring>
#include <memory>
#include <vector>

using namespace refraster;
using namespace refraster::test;

namespace {

template <class T>
bool same_lane(const T& a, const T& b, int lane) {
  const RealOf<T> x = a[lane], y = b[lane];
  return std::memcmp(&x, &y, sizeof x) == 0 || (x != x && y != y);
}

struct Tally {
  long rows = 0, uncommon = 0, textured = 0, turned = 0, wrong = 0;
};

// Every packet of a group, by both.
template <class T>
void compare(const FrameContext& context, const TinyFragments& tiny, const TinyFragments::Group& group,
             const PixelRect& tile, Tally& tally) {
  VertexNeeds needs = group.needs;
  needs.uvs = needs.derivatives = true;
  const Object& object = context.scene.objects[group.object];
  tiny.for_each_packet<T>(context, group, tile, [&](const TinyPacket<T>& packet, std::uint32_t) {
    const VertexData<T> data(context, packet, needs);
    if (!data.fits()) {
      ++tally.uncommon;
      return;
    }
    tally.turned += object.two_sided == TwoSided::yes;
    with_records(context, packet, [&](const auto& records) {
      const EdgeValues<T> a = data.template edges<Derivatives::yes>(), b = edge_values<Derivatives::yes>(records);
      for (int lane = 0; lane < packet.count; ++lane) {
        for (std::size_t k = 0; k < 3; ++k)
          tally.wrong += !same_lane(a.value[k], b.value[k], lane) || !same_lane(a.right[k], b.right[k], lane) ||
                         !same_lane(a.down[k], b.down[k], lane);
        for (int r = 0; r < uv_row + 2; ++r) {
          const auto x = data.row(r), y = records.row(r);
          const bool fourth = r < 3 || r >= max_uv_row;
          for (std::size_t c = 0; c < (fourth ? 4 : 3); ++c) tally.wrong += !same_lane(x[c], y[c], lane);
          ++tally.rows;
        }
        tally.textured += !(data.row(min_uv_row)[3][lane] > data.row(max_uv_row)[3][lane]);
      }
    });
  });
}

// Triangles of a pixel or so, in sheets that go on behind the eye; ordinary normals and others; textures on a part.
Scene tiny_scene(Random& random) {
  Scene scene;
  scene.camera.position = {0, 0, 2};
  const int count = 1 + random.below(3);
  for (int o = 0; o < count; ++o) {
    auto mesh = std::make_shared<Mesh>();
    const std::uint32_t side = 40;
    const float size = random.below(3) == 0 ? 4.0f : 1.0f; // of the sheet; 2.5 is behind the eye
    const double normals = random.below(3) == 0 ? random.log_uniform(1e-30, 1e30) : 1;
    for (std::uint32_t row = 0; row <= side; ++row)
      for (std::uint32_t column = 0; column <= side; ++column) {
        const auto at = [&](std::uint32_t i) { return size * (2 * static_cast<float>(i) / side - 1); };
        mesh->positions.emplace_back(at(column), at(row), random.uniform(-0.02, 0.02));
        const bool flat = random.below(4) == 0;
        mesh->normals.emplace_back(flat ? 0 : random.uniform(-1, 1) * normals,
                                   flat ? 0 : random.uniform(-1, 1) * normals, random.below(40) == 0 ? 0 : normals);
        if (row < side / 2) mesh->uvs.emplace_back(random.uniform(-3, 3), random.uniform(0, 1));
      }
    for (std::uint32_t row = 0; row < side; ++row)
      for (std::uint32_t column = 0; column < side; ++column) {
        const std::uint32_t low = row * (side + 1) + column, high = low + side + 1;
        mesh->triangles.push_back({low, low + 1, high + 1});
        mesh->triangles.push_back({high + 1, high, low});
      }
    Object object;
    object.mesh = mesh;
    object.rotate_degrees = {random.uniform(-80, 80), random.uniform(-80, 80), random.uniform(-180, 180)};
    object.position = {random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), random.uniform(-0.5, 0.5)};
    const auto scale = [&] { return random.sign() * random.uniform(0.7, 1.3); };
    object.scale = {scale(), scale(), scale()};
    object.two_sided = random.below(2) == 0 ? TwoSided::yes : TwoSided::no;
    scene.objects.push_back(object);
  }
  return scene;
}

template <class T>
void compare_scenes(Tally& tally) {
  for_all(300, [&](Random& random) {
    const Scene scene = random.below(4) == 0 ? random_scene(random) : tiny_scene(random);
    const RenderOptions options = random_options(random);
    const FrameInput input{scene, options};
    const BinnedGeometry stages(input);
    const FrameContext context{input, stages.geometry, stages.bins};
    const TileGrid grid = tile_grid(input);
    TileVisibility visibility(options.tile_size);
    std::vector<FragmentRun> runs;
    TinyFragments tiny;
    for (std::size_t index = 0; index < grid.tiles(); ++index) {
      const PixelRect tile = grid.tile(index);
      visibility.decide(context, index, tile);
      list_runs(visibility, tile, options.samples, runs);
      if (tiny.collect(context, {tile, visibility.triangles(), visibility}, runs) == 0) continue;
      for (const TinyFragments::Group& group : tiny.groups()) compare<T>(context, tiny, group, tile, tally);
    }
  });
}

} // namespace

TEST_CASE_TEMPLATE("data of vertices are those of records", T, Native<double>, Native<float>) {
  Tally tally;
  compare_scenes<T>(tally);
  CHECK(tally.wrong == 0);
  CHECK(tally.rows > 10000);
  CHECK(tally.uncommon > 50);
  CHECK(tally.textured > 1000);
  CHECK(tally.turned > 100);
}
