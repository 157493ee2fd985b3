// Shadow maps: what a map holds, against every triangle met with every texel's ray; where a surface lies in it, and
// what filters make of that, by hand; and the laws that hold for frames.

#include <refraster/mesh.h>
#include <refraster/render.h>

#include "raster/render_in.h"
#include "raster/shadow/map/depth_map.h"
#include "tests/support/invariants.h"
#include "tests/support/precisions.h"
#include "tests/support/random.h"
#include "tests/support/scenes/random_scene.h"
#include "tests/support/scenes/same_parts.h"
#include "tests/support/scenes/shadow_scene.h"
#include "tests/support/slow/slow_shadow_maps.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

namespace refraster::test {
namespace {

constexpr ShadowFilter every_filter[] = {ShadowFilter::nearest, ShadowFilter::two_by_two, ShadowFilter::pcf3};
ShadowMap map_of(int size, ShadowFilter filter = ShadowFilter::two_by_two, double bias = 1, double slope_bias = 2) {
  ShadowMap map;
  map.size = size, map.filter = filter, map.bias = bias, map.slope_bias = slope_bias;
  return map;
}

RenderOptions options_of(int width, int height, Precision precision = Precision::double_, int samples = 1) {
  RenderOptions options;
  options.width = width, options.height = height;
  options.precision = precision, options.samples = samples;
  options.want_radiance_double = true;
  options.aovs = all_aovs();
  return options;
}

/// The map of one light of a scene, as a frame has it.
template <class Light>
DepthMap drawn(const Scene& scene, const Light& light, int threads = 2, int tile_size = 64) {
  RenderOptions options = options_of(16, 16);
  options.threads = threads, options.tile_size = tile_size;
  DepthMap map;
  DepthMapScratch scratch;
  map.draw({scene, options}, casters_of(scene), light_view(light, world_box(scene, threads)), scratch);
  return map;
}

Object object_of(Mesh mesh, const Double3& position, const Double3& scale) {
  Object object;
  object.mesh = std::make_shared<const Mesh>(std::move(mesh));
  object.position = position, object.scale = scale;
  return object;
}

/// Over the floor y = 0 from -7 to 7 a sheet at y = 1 from z = -7 to 0.25, under a sun in the zenith. A map of 16
/// texels has texels of 1: columns run along +z, rows along +x, and the middle is (8, 8).
Scene sheet_over_floor(const ShadowMap& map) {
  Scene scene;
  scene.objects = {object_of(plane_mesh(1), {0, 0, 0}, {7, 1, 7}),
                   object_of(plane_mesh(1), {0, 1, (0.25 - 7) / 2}, {7, 1, (0.25 + 7) / 2})};
  scene.direction_lights = {{{0, -1, 0}, Double3(1), map}};
  return scene;
}

int different_pixels(const Frame& a, const Frame& b) {
  int count = 0;
  for (int y = 0; y < a.radiance_double.height; ++y)
    for (int x = 0; x < a.radiance_double.width; ++x)
      count += !std::equal(a.radiance_double.at(x, y), a.radiance_double.at(x, y) + 3, b.radiance_double.at(x, y));
  return count;
}

template <class Light>
void check_texels(const Scene& scene, const Light& light, int& covered, int& doubtful) {
  const DepthMap map = drawn(scene, light);
  const slow::SlowShadowMap slow(scene, light);
  const int size = light.shadow.map.size;
  for (std::size_t face = 0; face < map.view().faces(); ++face)
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column) {
        const auto stored = static_cast<slow::Real>(map.at(face, column, row));
        const slow::DepthDoubt expected = slow.texel(face, column, row);
        CAPTURE(face);
        CAPTURE(column);
        CAPTURE(row);
        CHECK(stored >= expected.lo);
        CHECK(stored <= expected.hi);
        covered += map.at(face, column, row) < 1;
        doubtful += expected.hi - expected.lo > 0.01L;
      }
}

} // namespace

TEST_CASE("every texel of a map holds the nearest of all triangles on its ray") {
  Scene scene = shadow_scene();
  for (Object& object : scene.objects) object.cull = Cull::back; // both sides cast shadows all the same
  int covered = 0, doubtful = 0;
  for (PointLight light : scene.point_lights) {
    light.shadow = map_of(16);
    check_texels(scene, light, covered, doubtful);
  }
  for (DirectionLight light : scene.direction_lights) {
    light.shadow = map_of(24);
    check_texels(scene, light, covered, doubtful);
  }
  CHECK(covered > 1000);
  CHECK(doubtful < covered / 10);
}

TEST_CASE("so they do in random scenes") {
  int covered = 0, doubtful = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Scene scene = random_scene(random);
    std::size_t triangles = 0;
    for (const Object& object : scene.objects) triangles += object.mesh->triangles.size();
    if (triangles > 300) continue;
    const auto ordinary = [](const Double3& v) { return std::max({abs(v.x), abs(v.y), abs(v.z)}) < 1e3; };
    if (!std::all_of(scene.objects.begin(), scene.objects.end(), [&](const Object& object) {
          return ordinary(object.position) && ordinary(object.scale) && ordinary(object.rotate_degrees);
        }))
      continue;
    PointLight point{{0.3, 0.9, -0.4}};
    DirectionLight sun{{0.4, -1, 0.3}};
    point.shadow = sun.shadow = map_of(16);
    check_texels(scene, point, covered, doubtful);
    check_texels(scene, sun, covered, doubtful);
  }
  CHECK(covered > 1000);
  CHECK(doubtful < covered / 2);
}

TEST_CASE("a view of the sun leaves a texel free about the scene and before and behind it") {
  const ShadowMap map = map_of(16);
  const Scene scene = sheet_over_floor(map);
  const LightView view = light_view(scene.direction_lights[0], world_box(scene, 1));
  CHECK(view.half == doctest::Approx(8).epsilon(1e-15)); // 7 * 16 / 14
  CHECK(view.origin == Double3(0, 0.5, 0));
  CHECK(view.axes.right == Double3(0, 0, 1));
  CHECK(view.axes.up == Double3(1, 0, 0));
  CHECK(view.near == doctest::Approx(-1.5).epsilon(1e-15));
  CHECK(view.far == doctest::Approx(1.5).epsilon(1e-15));
  const DepthMap drawn_map = drawn(scene, scene.direction_lights[0]);
  CHECK(static_cast<double>(drawn_map.at(0, 7, 8)) == doctest::Approx(1.0 / 3).epsilon(1e-6)); // the sheet
  CHECK(static_cast<double>(drawn_map.at(0, 8, 8)) == doctest::Approx(2.0 / 3).epsilon(1e-6)); // the floor
  CHECK(drawn_map.at(0, 0, 8) == 1);                                                           // nothing
}

TEST_CASE("filters compare the texels that they say, with the weights that they say") {
  const auto seen = [](ShadowFilter filter, const Double3& p) {
    const Scene scene = sheet_over_floor(map_of(16, filter, 0.25, 0));
    return drawn(scene, scene.direction_lights[0]).visibility(p, {0, 1, 0});
  };
  // Columns up to 7 hold the sheet, from 8 on the floor. z = -0.2 is at column 7.8, z = 0.2 at 8.2, both in row 8.
  const Double3 before(0, 0, -0.2), behind(0, 0, 0.2);
  CHECK(seen(ShadowFilter::nearest, before) == 0);
  CHECK(seen(ShadowFilter::nearest, behind) == 1);
  CHECK(seen(ShadowFilter::two_by_two, before) == doctest::Approx(0.3).epsilon(1e-12)); // 7.3 from the centres: 7 and 8
  CHECK(seen(ShadowFilter::two_by_two, behind) == doctest::Approx(0.7).epsilon(1e-12));
  CHECK(seen(ShadowFilter::pcf3, before) == 3.0 / 9); // columns 6, 7, 8
  CHECK(seen(ShadowFilter::pcf3, behind) == 6.0 / 9); // 7, 8, 9
  for (const ShadowFilter filter : every_filter) {
    CHECK(seen(filter, {0, 0, -3}) == 0);
    CHECK(seen(filter, {0, 0, 3}) == 1);
    CHECK(seen(filter, {0, 1, -3}) == 1);   // on the sheet
    CHECK(seen(filter, {0, -5, 300}) == 1); // beside the map
    CHECK(seen(filter, {0, -5, 3}) == 0);   // below the floor and beyond the far plane: what is behind it is nothing
    CHECK(seen(filter, {std::numeric_limits<double>::quiet_NaN(), 0, 0}) >= 0);
  }
}

TEST_CASE("the bias is in texels, and grows with the slope of the surface") {
  // A point at height 0.4 under the sheet lies 0.6 behind it.
  const auto lit_with = [](double bias, double slope_bias, const Double3& normal) {
    const Scene scene = sheet_over_floor(map_of(16, ShadowFilter::nearest, bias, slope_bias));
    return drawn(scene, scene.direction_lights[0]).visibility({0, 0.4, -3}, normal) == 1;
  };
  CHECK_FALSE(lit_with(0.59, 0, {0, 1, 0}));
  CHECK(lit_with(0.61, 0, {0, 1, 0}));
  // (3, 4, 2): across a texel along x the plane falls by 3/4, along z by 1/2.
  CHECK_FALSE(lit_with(0, 0.59 / 0.75, {3, 4, 2}));
  CHECK(lit_with(0, 0.61 / 0.75, {3, 4, 2}));
  CHECK(lit_with(0, 0.61 / 0.75, {-30, 40, 20}));
  CHECK(lit_with(0, 0.61 / 0.75, {2, -4, 3}));
  CHECK_FALSE(lit_with(0, 0.59, {1, 1, 0}));
  CHECK(lit_with(0, 1e-9, {1, 0, 0})); // grazed
  CHECK_FALSE(lit_with(0.5, 9, {0, 0, 0}));
}

TEST_CASE("a point light's bias is in texels at the distance along the face, and its slope that of the face") {
  Scene scene;
  scene.objects = {object_of(plane_mesh(1), {0, -2, 0}, {50, 1, 50}), object_of(plane_mesh(1), {0, -4, 0}, {8, 1, 8})};
  // On face -y at distance 4 a texel of 32 is 4 * 2 / 32 = 1/4 wide: 2 before the upper sheet are 8 texels.
  const auto lit_with = [&](double bias, double slope_bias, const Double3& p, const Double3& normal) {
    PointLight light{{0, 0, 0}};
    light.shadow = map_of(32, ShadowFilter::nearest, bias, slope_bias);
    return drawn(scene, light).visibility(p, normal) == 1;
  };
  CHECK_FALSE(lit_with(7.9, 0, {1, -4, 0.5}, {0, 1, 0}));
  CHECK(lit_with(8.1, 0, {1, -4, 0.5}, {0, 1, 0}));
  // The plane through (1, -4, 0.5) across (1, 2, 0): its depth 4 changes by 4 |n.x| / |n.d| = 4 / 7 for each unit
  // across, where n.d = 1 - 8 = -7.
  CHECK_FALSE(lit_with(0, 7.9 * 7 / 4, {1, -4, 0.5}, {1, 2, 0}));
  CHECK(lit_with(0, 8.1 * 7 / 4, {1, -4, 0.5}, {1, 2, 0}));
}

TEST_CASE("a direction falls in the face of its longest axis, x before y before z") {
  CHECK(cube_face_of({2, 1, -1}) == 0);
  CHECK(cube_face_of({-2, 1, -1}) == 1);
  CHECK(cube_face_of({1, 2, -1}) == 2);
  CHECK(cube_face_of({1, -2, -1}) == 3);
  CHECK(cube_face_of({1, 0, 3}) == 4);
  CHECK(cube_face_of({1, 2, -3}) == 5);
  CHECK(cube_face_of({1, 1, 1}) == 0);
  CHECK(cube_face_of({-1, 1, 1}) == 1);
  CHECK(cube_face_of({0.5, -1, 1}) == 3);
  CHECK(cube_face_of({0, 0, 0}) == 0);
  for (std::size_t face = 0; face < cube_faces; ++face) {
    const LightView view = light_view(PointLight{}, {Double3(-1), Double3(1)});
    const MapAxes axes = view.axes_of(face);
    CHECK(cross(axes.right, axes.up) == -axes.ahead);
    CHECK(cube_face_of(axes.ahead) == face);
  }
}

TEST_CASE("there is no gap where faces meet, and none is dark by itself") {
  Scene scene;
  scene.objects = {object_of(sphere_mesh(48, 24), {0.1, 0.2, -0.3}, Double3(1)),
                   object_of(sphere_mesh(8, 4), {0.1, 0.2, -0.3}, Double3(4))};
  for (const ShadowFilter filter : every_filter) {
    PointLight light{{0.1, 0.2, -0.3}};
    light.shadow = map_of(32, filter, 0.5, 0);
    const DepthMap map = drawn(scene, light);
    const auto check = [&](const Double3& direction) {
      const Double3 d = normalize(direction);
      CHECK(map.visibility(light.position + d * 0.8, d) == 1);
      CHECK(map.visibility(light.position + d * 1.4, d) == 0);
    };
    for (const double x : {-1.0, -0.999, 0.999, 1.0})
      for (const double y : {-1.0, 1.0, 0.3, 1.001})
        for (const double z : {-0.999, 0.2, 1.0}) check({x, y, z}), check({y, z, x}), check({z, x, y});
  }
}

TEST_CASE("near planes: what is nearer casts none, and the scene's bounds give one that all of it is behind") {
  Scene scene;
  scene.objects = {object_of(plane_mesh(1), {0, -0.5, 0}, {0.3, 1, 0.3}),
                   object_of(plane_mesh(1), {0, -2, 0}, {8, 1, 8})};
  PointLight light{{0, 0, 0}};
  light.shadow = map_of(64);
  CHECK(drawn(scene, light).visibility({0, -2, 0}, {0, 1, 0}) == 0);
  light.shadow.map.near = 0.6;
  CHECK(drawn(scene, light).visibility({0, -2, 0}, {0, 1, 0}) == 1);
  light.shadow.map.near = 0, light.position = {0, 30, 0};
  const LightView view = light_view(light, world_box(scene, 1));
  CHECK(view.near == doctest::Approx(30.5 / 2)); // half of the way to the box
  CHECK(view.far == doctest::Approx(32 * (1 + 2.0 / 64)));
}

TEST_CASE("maps are the same for every number of threads, tile size and crop, and so are their shadows") {
  const Scene scene = with_shadows(shadow_scene(), map_of(100));
  for (const DirectionLight& light : scene.direction_lights) {
    const DepthMap one = drawn(scene, light, 1, 8), other = drawn(scene, light, 5, 128);
    for (int row = 0; row < 100; ++row)
      for (int column = 0; column < 100; ++column) CHECK(one.at(0, column, row) == other.at(0, column, row));
  }
  for (const int samples : {1, 4}) check_same_parts(scene, options_of(77, 51, Precision::double_, samples));
}

TEST_CASE("every precision has the same map's shadows, fractions too") {
  Scene scene = with_shadows(shadow_scene(), map_of(64, ShadowFilter::pcf3));
  scene.direction_lights.clear();
  scene.point_lights = {{scene.point_lights[0].position, Double3(1), 0, 0, 0, map_of(64, ShadowFilter::pcf3)}};
  Phong matt;
  matt.ka = Double3(0), matt.kd = Double3(0), matt.ks = Double3(1), matt.glossiness = 0; // radiance times visibility
  for (Object& object : scene.objects) object.material.fragment_function = matt;
  scene.background = Double3(0);
  const Frame reference = render(scene, options_of(36, 24));
  int fractions = 0;
  for (const Precision precision : every_precision) {
    const Frame frame = render(scene, options_of(36, 24, precision));
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 36; ++x) {
        const double expected = reference.radiance_double.at(x, y)[0], value = frame.radiance_double.at(x, y)[0];
        CHECK(value == doctest::Approx(expected).epsilon(1e-6));
        CHECK(abs(std::round(expected * 9) - expected * 9) < 1e-12);
        fractions += expected > 0 && expected < 1;
      }
  }
  CHECK(fractions > 50);
}

TEST_CASE("a light with a map and nothing between is as one without") {
  Scene scene = shadow_scene();
  scene.objects.erase(scene.objects.begin() + 1, scene.objects.end()); // the floor alone
  const RenderOptions options = options_of(60, 40);
  const Frame lit = render(with_shadows(scene, Shadow::none), options);
  // A flat surface rises by at most its slope times as many texels as a tap is off, half a texel more along both axes.
  for (const auto& [filter, slope_bias] :
       {std::pair(ShadowFilter::nearest, 1.0), {ShadowFilter::two_by_two, 2.0}, {ShadowFilter::pcf3, 3.0}})
    for (const int size : {16, 100, 400})
      CHECK(difference(render(with_shadows(scene, map_of(size, filter, 0.25, slope_bias)), options), lit) == "");
  CHECK(different_pixels(render(with_shadows(scene, map_of(64, ShadowFilter::nearest, 0, 0)), options), lit) > 100);
}

TEST_CASE("the larger a map, the nearer its shadows are to exact ones") {
  Scene scene = shadow_scene();
  scene.point_lights.resize(1), scene.direction_lights.resize(1);
  const RenderOptions options = options_of(90, 60);
  const Frame exact = render(with_shadows(scene, Shadow::exact), options);
  int last = 90 * 60;
  for (const int size : {64, 256, 1024}) {
    const Frame frame = render(with_shadows(scene, map_of(size, ShadowFilter::nearest, 0.5, 1)), options);
    const int different = different_pixels(frame, exact);
    CHECK(different < last);
    last = different;
  }
  CHECK(last < 90 * 60 / 50);
}

TEST_CASE("bounds hold what double makes of a map's shadow") {
  const Scene scene = with_shadows(shadow_scene(), map_of(64));
  const RenderOptions options = options_of(24, 16);
  const Frame frame = render(scene, options);
  using Bounds = Interval<DoubleArithmetic>;
  const Image<Bounds> bounds = render_in<Bounds>(scene, options);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 24; ++x)
      for (int c = 0; c < 3; ++c) {
        CHECK(bounds.at(x, y)[c].lo <= frame.radiance_double.at(x, y)[c]);
        CHECK(frame.radiance_double.at(x, y)[c] <= bounds.at(x, y)[c].hi);
      }
}

TEST_CASE("maps ask for their memory, and a renderer keeps them") {
  const Scene scene = with_shadows(shadow_scene(), map_of(256));
  RenderOptions options = options_of(16, 16);
  options.memory = MemoryBudget(300000, [] { return std::uint64_t{0}; });
  bool refused = false;
  try {
    render(scene, options);
  } catch (const OutOfMemory& error) {
    refused = std::string_view(error.what()).find("the shadow maps") != std::string_view::npos;
  }
  CHECK(refused);
  Renderer renderer;
  Frame first, second, without, exact;
  const RenderOptions plain = options_of(40, 30);
  renderer.render(scene, plain, first);
  renderer.render(with_shadows(scene, Shadow::none), plain, without);
  renderer.render(with_shadows(scene, Shadow::exact), plain, exact);
  renderer.render(scene, plain, second);
  CHECK(difference(first, second) == "");
  CHECK(difference(first, without) != "");
  CHECK(difference(first, exact) != "");
}

TEST_CASE("a map that cannot be drawn is refused, and a strange scene is not") {
  Scene scene = with_shadows(shadow_scene(), map_of(15));
  CHECK_THROWS_WITH(render(scene, options_of(4, 4)),
                    doctest::Contains("point_lights/0/shadow/map: found 15, expected finite numbers from 16 to 8192"));
  scene = with_shadows(shadow_scene(), map_of(8193));
  CHECK_THROWS(render(scene, options_of(4, 4)));
  const Scene empty =
      with_shadows({.point_lights = {PointLight{}}, .direction_lights = {DirectionLight{}}}, map_of(16));
  CHECK(render(empty, options_of(4, 4)).counts.shaded == 0);
  for (const double size : {1e-300, 1e-30, 1e30, 1e300}) {
    Scene strange = with_shadows(shadow_scene(), map_of(16));
    for (Object& object : strange.objects) object.scale *= size, object.position *= size;
    strange.camera.position *= size, strange.camera.near = size * 0.1, strange.camera.far = size * 60;
    for (PointLight& light : strange.point_lights) light.position *= size;
    const Frame frame = render(strange, options_of(24, 16));
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 24; ++x) CHECK(std::isfinite(frame.radiance_double.at(x, y)[0]));
  }
}

} // namespace refraster::test
