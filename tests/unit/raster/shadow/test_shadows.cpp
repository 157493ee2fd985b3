// Shadows in frames: the same for every precision, thread, tile and crop; without speckles on what no other thing
// shades; a factor of what arrives, whatever the fragment function.

#include <refraster/mesh.h>
#include <refraster/render.h>

#include "raster/explain/explain_dark.h"
#include "raster/render_in.h"
#include "shading/user_function.h"
#include "tests/support/invariants.h"
#include "tests/support/precisions.h"
#include "tests/support/scenes/leaf_scene.h"
#include "tests/support/scenes/same_parts.h"
#include "tests/support/scenes/shadow_scene.h"
#include "tests/support/shading/each_fragment_function.h"
#include "tests/support/shading/merl_tables.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

namespace refraster::test {
namespace {

Phong matt(const Double3& ka = Double3(0)) {
  Phong phong;
  phong.ka = ka, phong.kd = Double3(1), phong.ks = Double3(0);
  return phong;
}

Object object_of(Mesh mesh, const FragmentFunction& function = matt()) {
  Object object;
  object.mesh = std::make_shared<const Mesh>(std::move(mesh));
  object.material.fragment_function = function;
  return object;
}

RenderOptions options_of(int width, int height, Precision precision = Precision::double_, int samples = 1) {
  RenderOptions options;
  options.width = width, options.height = height;
  options.precision = precision, options.samples = samples;
  options.want_radiance_double = true;
  options.aovs = all_aovs();
  return options;
}

bool is_black(const Frame& frame, int x, int y) {
  const double* const rgb = frame.radiance_double.at(x, y);
  return rgb[0] == 0 && rgb[1] == 0 && rgb[2] == 0;
}

/// Seen from above, the floor y = 0 and over it, at y = 1 and out of view, a square from -0.5 to 0.5.
Scene square_over_floor(const Double3& lamp) {
  Scene scene;
  scene.camera = {{0, 0.9, 0}, {0, 0, 0}, {0, 0, -1}, 120, 0.1, 10};
  scene.point_lights = {{lamp, Double3(1), 1, 0, 0, Shadow::exact}};
  Object floor = object_of(plane_mesh(3)), square = object_of(plane_mesh(1));
  floor.scale = Double3(8, 1, 8), square.scale = Double3(0.5, 1, 0.5), square.position = {0, 1, 0};
  scene.objects = {floor, square};
  return scene;
}

/// The normal of a triangle of an object that is not turned or scaled.
Double3 facet(const Object& object, std::uint32_t triangle) {
  const auto corner = [&](std::size_t k) {
    return Double3(object.mesh->positions[object.mesh->triangles[triangle][k]]) + object.position;
  };
  return cross(corner(1) - corner(0), corner(2) - corner(0));
}

} // namespace

TEST_CASE("the shadow of a square is where similar triangles put it, in every precision") {
  const Double3 lamp(0.3, 2, -0.2);
  const Scene scene = square_over_floor(lamp);
  // From the lamp, at twice the square's height, its shadow is twice as large.
  const double low_x = lamp.x + 2 * (-0.5 - lamp.x), high_x = lamp.x + 2 * (0.5 - lamp.x);
  const double low_z = lamp.z + 2 * (-0.5 - lamp.z), high_z = lamp.z + 2 * (0.5 - lamp.z);
  for (const Precision precision : every_precision) {
    const int side = precision == Precision::exact ? 20 : 64; // 60 digits take long
    const Frame frame = render(scene, options_of(side, side, precision));
    const Image<float>& position = frame.aovs[static_cast<std::size_t>(Aov::position)];
    int in_shadow = 0;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const double px = static_cast<double>(position.at(x, y)[0]), pz = static_cast<double>(position.at(x, y)[2]);
        const auto near = [](double a, double b) { return std::abs(a - b) < 1e-5; };
        if (near(px, low_x) || near(px, high_x) || near(pz, low_z) || near(pz, high_z)) continue;
        const bool expected = px > low_x && px < high_x && pz > low_z && pz < high_z;
        CHECK(is_black(frame, x, y) == expected);
        in_shadow += expected;
      }
    CHECK(in_shadow > side * side / 4);
    CHECK(in_shadow < side * side * 3 / 4);
  }
}

TEST_CASE("a light with a shadow and nothing between is as one without") {
  Scene scene = shadow_scene();
  scene.objects.erase(scene.objects.begin() + 1, scene.objects.end()); // the floor alone
  for (const Precision precision : every_precision)
    for (const int samples : {1, 4}) {
      const RenderOptions options = options_of(20, 12, precision, samples);
      CHECK(difference(render(scene, options), render(with_shadows(scene, Shadow::none), options)) == "");
    }
}

TEST_CASE("a convex body shades exactly those of its facets that are turned away, and no pixel of another") {
  Scene scene;
  scene.camera.position = {0.2, 0.3, 3};
  scene.direction_lights = {{{-1, -0.7, -0.4}, Double3(1), Shadow::exact}};
  const Double3 to_light = -scene.direction_lights[0].direction;
  for (const Double3& position : {Double3(0), Double3(1e-3, 0.1, 0.7), Double3(0.1, 0, -300)}) {
    scene.objects = {object_of(sphere_mesh(24, 12))};
    scene.objects[0].position = position;
    scene.camera.target = position, scene.camera.far = 1000;
    scene.camera.fov_y_degrees = position.z < -100 ? 0.4 : 45;
    RenderOptions options = options_of(96, 96);
    const Frame shaded = render(scene, options), lit = render(with_shadows(scene, Shadow::none), options);
    const Image<float>& triangle = shaded.aovs[static_cast<std::size_t>(Aov::triangle)];
    int dark = 0, terminator = 0, bright = 0;
    for (int y = 0; y < 96; ++y)
      for (int x = 0; x < 96; ++x) {
        const auto number = static_cast<std::uint32_t>(*triangle.at(x, y));
        if (number == 0) continue;
        const double toward = dot(normalize(facet(scene.objects[0], number - 1)), normalize(to_light));
        if (std::abs(toward) < 1e-6) continue; // a facet's corners are rounded
        if (toward < 0) {
          ++dark;
          CHECK(is_black(shaded, x, y));
          terminator += !is_black(lit, x, y); // n.l > 0 of the normal that is interpolated
        } else {
          ++bright;
          CHECK(std::equal(shaded.radiance_double.at(x, y), shaded.radiance_double.at(x, y) + 3,
                           lit.radiance_double.at(x, y)));
        }
      }
    CHECK(dark > 500);
    CHECK(bright > 500);
    CHECK(terminator > 20);
  }
}

TEST_CASE("no wall of a room has a speckle, in its corners either") {
  // Seen from within: every pixel sees the lamp, whatever facet, edge or corner it is on.
  Scene scene;
  scene.camera = {{0.1, 0.2, 0.6}, {-0.4, -0.3, -1}, {0, 1, 0}, 110, 0.01, 10};
  scene.objects = {object_of(cube_mesh())};
  scene.objects[0].rotate_degrees = {10, 20, 30}, scene.objects[0].scale = {1.3, 0.9, 1.7};
  scene.objects[0].two_sided = TwoSided::yes;
  for (const Double3& lamp : {Double3(0.1, 0.3, 0.2), Double3(0.5, -0.3, 0.6)}) {
    scene.point_lights = {{lamp, Double3(1), 1, 0, 0, Shadow::exact}};
    for (const int samples : {1, 8}) {
      const RenderOptions options = options_of(120, 90, Precision::double_, samples);
      CHECK(difference(render(scene, options), render(with_shadows(scene, Shadow::none), options)) == "");
    }
  }
}

TEST_CASE("every precision has the same shadows, with one sample and with several") {
  Scene scene = with_shadows(shadow_scene(), Shadow::exact);
  scene.direction_lights.clear();
  scene.point_lights.resize(1);
  for (Object& object : scene.objects) object.material.fragment_function = matt(), object.two_sided = TwoSided::yes;
  scene.background = Double3(1);
  for (const int samples : {1, 4}) {
    const Frame reference = render(scene, options_of(36, 24, Precision::double_, samples));
    int dark = 0;
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 36; ++x) dark += is_black(reference, x, y);
    CHECK(dark > 75);
    for (const Precision precision : every_precision) {
      const Frame frame = render(scene, options_of(36, 24, precision, samples));
      for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 36; ++x) CHECK(is_black(frame, x, y) == is_black(reference, x, y));
    }
  }
}

TEST_CASE("shadows are the same for every number of threads, tile size and crop") {
  const Scene scene = shadow_scene();
  for (const int samples : {1, 4}) check_same_parts(scene, options_of(77, 51, Precision::double_, samples));
}

TEST_CASE("what is culled, out of view, or cut out by opacity casts its whole shadow") {
  const Double3 lamp(0.3, 2, -0.2);
  const RenderOptions options = options_of(48, 48);
  const Scene plain = square_over_floor(lamp);
  const Frame expected = render(plain, options);
  Scene culled = plain;
  culled.objects[1].cull = Cull::back; // seen from below
  culled.camera.position.y = 0.95;
  Scene above = plain; // the camera sees it
  above.camera.position.y = 0.95;
  CHECK(difference(render(culled, options), render(above, options)) == "");
  Scene cut = plain;
  Mesh with_uvs = leaf_card(1);
  cut.objects[1] = object_of(with_uvs);
  cut.objects[1].rotate_degrees = {-90, 0, 0}, cut.objects[1].scale = {0.5, 0.5, 1},
  cut.objects[1].position = {0, 1, 0};
  cut.objects[1].material.opacity_map.texture = std::make_shared<const Texture>(leaf_opacity(8));
  cut.objects[1].material.opacity_threshold = 1;
  const Frame holes = render(cut, options);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x) CHECK(is_black(holes, x, y) == is_black(expected, x, y));
}

namespace {

/// As the kit has it: radiance that arrives, whatever the direction.
struct Collector {
  static constexpr std::string_view name = "collector";
  static void fields(auto&, auto&&) {}
};
template <Number T>
Rgb<T> ambient(const Collector&, const Fragment<T>&) {
  return Rgb<T>(T(0));
}
template <Number T>
Rgb<T> reflected(const Collector&, const Fragment<T>&, const Incident<T>& light) {
  return light.radiance;
}

} // namespace

TEST_CASE("no fragment function gets light through a triangle, nor does one of the user's") {
  constexpr int side = 16;
  const RenderOptions options = options_of(side, side);
  Scene scene = square_over_floor({0.3, 2, -0.2});
  const Frame expected = render(scene, options);
  const auto check = [&](const Scene& other, const char* name) {
    CAPTURE(name);
    for (const Precision precision : every_precision) {
      RenderOptions in = options;
      in.precision = precision;
      const Frame frame = render(other, in);
      int lit = 0;
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
          if (is_black(expected, x, y)) CHECK(is_black(frame, x, y));
          lit += !is_black(frame, x, y);
        }
      CHECK(lit > 50);
    }
  };
  for (FragmentFunction function : each_fragment_function()) {
    std::visit(
        [](auto& of) {
          if constexpr (requires { of.ka; }) of.ka = Double3(0);
          if constexpr (requires { of.table; }) of.table = ragged_table();
        },
        function);
    Scene other = scene;
    other.objects[0].material.fragment_function = function;
    check(other, std::string(name_of(function)).c_str());
  }
  Scene other = scene;
  other.objects[0].material.user_function = user_function<Collector>();
  check(other, "collector");
  // Of several lights, each its own.
  other.point_lights.insert(other.point_lights.begin(), {{0, 0.5, 0}, Double3(2), 1, 0, 0});
  other.point_lights.push_back({{-0.3, 2, 0.2}, Double3(8), 1, 0, 0, Shadow::exact});
  const Frame sums = render(other, options);
  std::vector<int> of_sum(16);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) ++of_sum.at(static_cast<std::size_t>(sums.radiance_double.at(x, y)[0]));
  for (const std::size_t sum : {2u, 3u, 10u, 11u}) CHECK(of_sum[sum] > 5);
  CHECK(of_sum[2] + of_sum[3] + of_sum[10] + of_sum[11] == side * side);
}

TEST_CASE("bounds hold what a device may make of a shadow, and what double makes of it") {
  const Scene scene = shadow_scene();
  const RenderOptions options = options_of(24, 16);
  const Frame frame = render(scene, options);
  using Bounds = Interval<DoubleArithmetic>;
  const Image<Bounds> bounds = render_in<Bounds>(scene, options);
  const Frame lit = render(with_shadows(scene, Shadow::none), options);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 24; ++x)
      for (int c = 0; c < 3; ++c) {
        const Bounds& range = bounds.at(x, y)[c];
        CHECK(range.lo <= frame.radiance_double.at(x, y)[c]);
        CHECK(lit.radiance_double.at(x, y)[c] <= range.hi);
      }
}

TEST_CASE("an image that is dark for its shadows is said to be") {
  Scene scene = square_over_floor({0, 2, 0});
  scene.objects[1].scale = Double3(100, 1, 100);
  RenderOptions options;
  options.width = options.height = 16;
  const Frame frame = render(scene, options);
  CHECK(explain_dark_image(scene, options, {frame.rgb8, frame.radiance}, frame.counts.shaded) ==
        "the image is nearly black, no value above 0 of 255: what is seen lies in shadow");
}

TEST_CASE("shadows ask for their memory, and a renderer keeps it") {
  const Scene scene = shadow_scene();
  RenderOptions options = options_of(16, 16);
  options.memory = MemoryBudget(60000, [] { return std::uint64_t{0}; });
  bool refused = false;
  try {
    render(scene, options);
  } catch (const OutOfMemory& error) {
    refused = std::string_view(error.what()).find("the shadows") != std::string_view::npos;
  }
  CHECK(refused);
  Renderer renderer;
  Frame first, second, without;
  const RenderOptions plain = options_of(40, 30);
  renderer.render(scene, plain, first);
  renderer.render(with_shadows(scene, Shadow::none), plain, without);
  renderer.render(scene, plain, second);
  CHECK(difference(first, second) == "");
  CHECK(difference(first, without) != "");
}

} // namespace refraster::test
