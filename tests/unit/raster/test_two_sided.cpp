// Objects that are lit from both of their sides.

#include <refraster/render.h>

#include "raster/vertex/transform.h"
#include "tests/support/precisions.h"
#include "tests/support/raster/window_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace refraster::test {
namespace {

/// A triangle over the whole view, with corners in this order, normals that differ, and light from the side.
WindowScene lit_triangle(const std::vector<Float3>& corners, float normals) {
  WindowScene window(4);
  Object& object = window.add(corners);
  auto mesh = std::make_shared<Mesh>(*object.mesh);
  mesh->normals = {Float3(0.1f, 0.2f, 1) * normals, Float3(-0.3f, 0, 2) * normals, Float3(0, 0.5f, 1) * normals};
  object.mesh = mesh;
  object.material.fragment_function = BlinnPhong{};
  window.scene.direction_lights = {{Double3(-1, -2, -3), Double3(1)}, {Double3(1, 0, 1), Double3(0.5)}};
  return window;
}

RenderOptions with_normals(const WindowScene& window, Precision precision, int samples = 1) {
  RenderOptions options = window.options({Aov::normal, Aov::position}, samples);
  options.precision = precision;
  return options;
}

/// Of the sides that a pixel's normal and its eye are on, for each pixel that shows a surface.
std::vector<double> n_v(const Scene& scene, int side) {
  RenderOptions options;
  options.width = options.height = side, options.threads = 1;
  options.aovs = {Aov::normal, Aov::position, Aov::object};
  const Frame frame = render(scene, options);
  std::vector<double> result;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      if (!is_drawn(frame, x, y, 2)) continue;
      const float *const n = frame.aovs[0].at(x, y), *const p = frame.aovs[1].at(x, y);
      const Double3 to_eye = scene.camera.position - Double3(Float3(p[0], p[1], p[2]));
      result.push_back(dot(Double3(Float3(n[0], n[1], n[2])), normalize(to_eye)));
    }
  return result;
}

Scene ball(const Double3& scale) {
  Scene scene;
  scene.camera.position = Double3(0, 0, 5), scene.camera.target = Double3(0);
  Object object;
  object.mesh = std::make_shared<const Mesh>(sphere_mesh(24, 12));
  object.rotate_degrees = {20, 30, 40}, object.scale = scale;
  object.two_sided = TwoSided::yes;
  scene.objects.push_back(object);
  return scene;
}

} // namespace

TEST_CASE("a two-sided triangle shows from behind what it shows with normals reversed, bit for bit") {
  const WindowScene at(4);
  const Float3 a = at.place(-4, -4, 1), b = at.place(-4, 12, 2), c = at.place(12, -4, 1);
  const Float3 left = at.place(-8, 1, 4), right = at.place(12, 1, 4), behind(0, -2, 2);
  for (const Precision precision : every_precision)
    for (const int samples : {1, 4})
      // Corners on the lattice, and one behind the eye.
      for (const std::vector<Float3>& front : {std::vector{a, b, c}, std::vector{left, behind, right}}) {
        CAPTURE(static_cast<int>(precision));
        const std::vector<Float3> back{front[0], front[2], front[1]};
        const auto frame = [&](const std::vector<Float3>& corners, float normals, TwoSided two_sided) {
          WindowScene window = lit_triangle(corners, normals);
          window.scene.objects[0].two_sided = two_sided;
          return render(window.scene, with_normals(window, precision, samples));
        };
        const bool is_front = frame(front, 1, TwoSided::yes).radiance.values == //
                              frame(front, 1, TwoSided::no).radiance.values;
        const std::vector<Float3>&facing = is_front ? front : back, &away = is_front ? back : front;
        CHECK(frame(facing, 1, TwoSided::yes).radiance.values == frame(facing, 1, TwoSided::no).radiance.values);
        const Frame turned = frame(away, 1, TwoSided::yes), reversed = frame(away, -1, TwoSided::no);
        CHECK(turned.radiance.values == reversed.radiance.values);
        CHECK(turned.aovs[0].values == reversed.aovs[0].values);
        CHECK(turned.radiance.values != frame(away, 1, TwoSided::no).radiance.values);
        CHECK(turned.counts.drawn == 1);
      }
}

TEST_CASE("whatever is mirrored, a two-sided ball has normals toward the eye, outside as inside") {
  for (const double x : {-1.0, 1.0})
    for (const double y : {-0.5, 0.5})
      for (const double z : {-2.0, 2.0}) {
        CAPTURE(x);
        CAPTURE(y);
        CAPTURE(z);
        Scene scene = ball({x, y, z});
        std::vector<double> seen = n_v(scene, 32);
        REQUIRE(seen.size() > 100);
        // Of a ball's outermost triangles the interpolated normal may point a little away.
        CHECK(*std::min_element(seen.begin(), seen.end()) > -0.3);
        CHECK(std::count_if(seen.begin(), seen.end(), [](double c) { return c > 0; }) > 0.95 * double(seen.size()));
        scene.camera.position = Double3(0.1, 0.1, 0.1), scene.camera.target = Double3(1, 2, 3);
        seen = n_v(scene, 32);
        REQUIRE(seen.size() == 32 * 32);
        CHECK(*std::min_element(seen.begin(), seen.end()) > 0);
        scene.objects[0].two_sided = TwoSided::no;
        seen = n_v(scene, 32);
        CHECK(*std::max_element(seen.begin(), seen.end()) < 0);
      }
}

TEST_CASE("a model mirrors if an odd number of its scales is below 0; flattened it does not") {
  const auto mirrors = [](const Double3& scale) {
    Object object;
    object.scale = scale;
    return is_mirrored(object);
  };
  CHECK(mirrors({-1, 1, 1}));
  CHECK(mirrors({-1e-300, -1e-300, -1e-300}));
  CHECK_FALSE(mirrors({-1e-300, 1e-300, -1e-300}));
  CHECK_FALSE(mirrors({1, 1, 1}));
  for (const double zero : {0.0, -0.0}) {
    CHECK_FALSE(mirrors({-1, zero, 1}));
    CHECK_FALSE(mirrors({zero, -1, -1}));
  }
}

TEST_CASE("a triangle's own normal, where the mesh gives none, is turned too") {
  for (const Precision precision : every_precision)
    for (const double mirror : {1.0, -1.0}) {
      const WindowScene at(4);
      WindowScene window = lit_triangle({at.place(-4, -4, 1), at.place(12, -4, 1), at.place(-4, 12, 2)}, 0);
      Object& object = window.scene.objects[0];
      object.scale.x = mirror;
      const auto z = [&](TwoSided two_sided) {
        object.two_sided = two_sided;
        return render(window.scene, with_normals(window, precision)).aovs[0].at(2, 1)[2];
      };
      const float own = z(TwoSided::no), turned = z(TwoSided::yes);
      CHECK(own < 0);
      CHECK(turned == -own);
    }
}

TEST_CASE("culling asks for the side that is seen in the window, two-sided or not") {
  Scene scene = ball({-1, 1, 1});
  scene.objects[0].cull = Cull::back;
  const std::vector<double> seen = n_v(scene, 32); // mirrored, the outside is its back: the inside is seen
  scene.objects[0].two_sided = TwoSided::no;
  const std::vector<double> away = n_v(scene, 32);
  REQUIRE(seen.size() == away.size());
  REQUIRE(seen.size() > 100);
  for (std::size_t i = 0; i < seen.size(); ++i) CHECK(seen[i] == -away[i]);
}

} // namespace refraster::test
