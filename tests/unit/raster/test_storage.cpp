// What is stored of an object's vertices changes nothing of what is seen.

#include "raster/shade/attribute_setup.h"
#include "raster/vertex/outside.h"
#include "raster/visibility/visibility.h"
#include "tests/support/for_all.h"
#include "tests/support/scenes/random_scene.h"

#include <doctest/doctest.h>

#include <cstring>
#include <memory>
#include <tuple>

using namespace refraster;
using namespace refraster::test;

namespace {

// The stages before shading.
struct Stages {
  Geometry geometry;
  Bins bins;
  FrameCounts counts;

  // All vertices stored, or as few as may be.
  Stages(const FrameInput& input, bool all) {
    if (all) {
      transform(input, geometry);
    } else {
      lay_out(input, geometry, {.stored = 0, .on_demand = SIZE_MAX});
      transform_stored(input, geometry);
    }
    bin_triangles(input, geometry, bins, counts);
  }
  FrameContext context(const FrameInput& input) const { return {input, geometry, bins}; }
};

bool same(const FrameCounts& a, const FrameCounts& b) {
  const auto all = [](const FrameCounts& c) {
    return std::tuple(c.triangles, c.drawn, c.clipped, c.outside, c.culled, c.degenerate, c.between_samples,
                      c.not_finite);
  };
  return all(a) == all(b);
}

template <class Real>
std::vector<AttributeSetup<Real>> setups_of(const FrameContext& context, std::span<const std::uint32_t> numbers,
                                            UncommonEdges& uncommon) {
  std::vector<VisibleTriangle> visible;
  TriangleFinder finder(context.scene, context.geometry);
  for (const std::uint32_t number : numbers) visible.push_back({finder.at(number), number});
  std::vector<AttributeSetup<Real>> setups(visible.size());
  set_up_attributes<Real>(context, visible, setups, uncommon);
  return setups;
}

template <class Real>
bool same_setups(const FrameContext& a, const FrameContext& b, std::span<const std::uint32_t> numbers) {
  UncommonEdges uncommon_a, uncommon_b;
  const auto setups_a = setups_of<Real>(a, numbers, uncommon_a), setups_b = setups_of<Real>(b, numbers, uncommon_b);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const AttributeSetup<Real>&x = setups_a[i], &y = setups_b[i];
    if (x.object != y.object || x.number != y.number || x.kind() != y.kind()) return false;
    const Mesh& mesh = *a.scene.objects[x.object].mesh;
    bool same_rows = true;
    for_each_attribute_row([&](const auto& attribute, int row) {
      const bool is_set =
          row <= uv_row || ((a.uses.vertex_colours || a.uses.tangents) && !(mesh.*attribute.values).empty());
      const auto first = static_cast<std::size_t>(row);
      if (is_set && std::memcmp(&x.row[first], &y.row[first], attribute.components * sizeof x.row[0]) != 0)
        same_rows = false;
    });
    if (!same_rows) return false;
    if (x.kind() == EdgeKind::wrapped && std::memcmp(x.edge.data(), y.edge.data(), sizeof x.edge) != 0) return false;
    if (x.kind() == EdgeKind::large)
      for (std::size_t k = 0; k < 3; ++k)
        if (x.large->edge[k].a != y.large->edge[k].a || x.large->edge[k].b != y.large->edge[k].b ||
            x.large->edge[k].c != y.large->edge[k].c)
          return false;
  }
  return true;
}

// The scene's objects, and some of them again beyond each side of the view.
Scene spread_scene(Random& random) {
  Scene scene = random_scene(random);
  const std::size_t count = scene.objects.size();
  for (std::size_t o = 0; o < count; ++o) {
    Object object = scene.objects[o];
    const auto far = [&] { return random.uniform(-40, 40); };
    object.position = {far(), far(), far()};
    scene.objects.push_back(object);
  }
  return scene;
}

} // namespace

TEST_CASE("a frame that stores no vertex sees the same, and sets up the same") {
  for_all(150, [](Random& random) {
    const Scene scene = spread_scene(random);
    RenderOptions options = random_options(random);
    const FrameInput input{scene, options};
    const Stages all(input, true), none(input, false);
    REQUIRE(none.geometry.window.size() == 0);
    CHECK(same(all.counts, none.counts));
    const TileGrid grid = tile_grid(input);
    const FrameContext a = all.context(input), b = none.context(input);
    TileVisibility seen_a(options.tile_size), seen_b(options.tile_size);
    for (std::size_t index = 0; index < grid.tiles(); ++index) {
      const PixelRect tile = grid.tile(index);
      seen_a.decide(a, index, tile), seen_b.decide(b, index, tile);
      const auto numbers = seen_a.triangles();
      REQUIRE(std::equal(numbers.begin(), numbers.end(), seen_b.triangles().begin(), seen_b.triangles().end()));
      long wrong = 0;
      for (int s = 0; s < options.samples; ++s)
        for (int y = 0; y < tile.height; ++y)
          for (int x = 0; x < tile.width; ++x)
            wrong += seen_a.nearest(s, x, y) != seen_b.nearest(s, x, y) ||
                     (seen_a.nearest(s, x, y) >= 0 && seen_a.depth(s, x, y) != seen_b.depth(s, x, y));
      REQUIRE(wrong == 0);
      CHECK(same_setups<double>(a, b, numbers));
      CHECK(same_setups<float>(a, b, numbers));
    }
  });
}

TEST_CASE("what counts as outside the view has no vertex within: at its edges, and far from them") {
  int outside = 0, near_edge = 0, at_edge = 0;
  for_all(3000, [&](Random& random) {
    Scene scene;
    scene.camera.position = {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)};
    scene.camera.target = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    scene.camera.fov_y_degrees = random.uniform(5, 150);
    scene.camera.near = random.uniform(0.01, 1), scene.camera.far = random.uniform(2, 20);
    auto mesh = std::make_shared<Mesh>(cube_mesh());
    while (mesh->positions.size() < 64) { // fewer are not looked at
      mesh->positions.push_back(mesh->positions[mesh->positions.size() % 24]);
      mesh->normals.push_back({0, 0, 1});
    }
    const double size = std::exp2(random.uniform(-40, 3));
    for (int o = 0; o < 2; ++o) {
      Object object;
      object.mesh = mesh;
      object.rotate_degrees = {random.uniform(-180, 180), random.uniform(-180, 180), random.uniform(-180, 180)};
      object.scale = Double3(size) * Double3(random.uniform(-1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1));
      object.position = {random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)};
      if (o == 1) { // on the left plane, as near as doubles allow
        const Double4x4 clip = clip_from_world(scene.camera, 1);
        const auto value = [&](double x) {
          const Double4 c = clip * Double4(x, object.position.y, object.position.z, 1);
          return c.x + c.w;
        };
        double low = -30, high = 30;
        const bool below = value(low) < 0;
        for (int step = 0; step < 60 && below != (value(high) < 0); ++step) {
          const double middle = (low + high) / 2;
          ((value(middle) < 0) == below ? low : high) = middle;
        }
        object.position.x = low;
        at_edge += abs(value(low)) < 0x1p-40;
      }
      scene.objects.push_back(object);
    }
    RenderOptions options;
    options.width = options.height = 64, options.threads = 1;
    const FrameInput input{scene, options};
    Geometry geometry;
    transform(input, geometry);
    std::vector<Storage> storage(scene.objects.size(), Storage::stored);
    find_outside(input, geometry.transforms, storage);
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
      int common = outcode::sides, any = 0;
      for (std::uint32_t v = geometry.first_vertex[o]; v < geometry.first_vertex[o + 1]; ++v)
        common &= geometry.window[v].outcode, any |= geometry.window[v].outcode;
      const bool is_outside = common != 0 && !(any & outcode::not_finite);
      outside += is_outside;
      if (storage[o] == Storage::outside) CHECK(is_outside);
      else near_edge += is_outside; // the box says no more, or roundings might
    }
  });
  CHECK(at_edge > 1000);
  CHECK(outside > 1000);
}
