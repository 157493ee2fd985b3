// The library with the fragment function of CONTRIBUTING.md in its own list: what follows from the list knows it, and
// it shades as the same function does from outside.

#include <refraster/files.h>
#include <refraster/mesh.h>
#include <refraster/render.h>

#include "io/scene/scene_markdown.h"
#include "minnaert.h"
#include "tests/support/scenes/random_scene.h"
#include "tests/support/scenes/same_shading.h"
#include "tests/support/shading/each_fragment_function.h"
#include "tests/support/slow/slow_shading.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

using namespace refraster;

namespace {

/// Two balls on a plane, textured, under a light of each kind.
Scene moons() {
  Scene scene;
  scene.camera.position = {0, 1, 5};
  scene.camera.target = {0, 0, 0};
  scene.point_lights = {{.position = {2, 3, 4}, .radiance = Double3(3), .quadratic = 0.1}};
  scene.direction_lights = {{{-1, -1, -1}, Double3(0.5)}};
  auto texture = std::make_shared<Texture>();
  TextureLevel& level = texture->levels.emplace_back();
  level.width = level.height = 2;
  level.rgb = {255, 51, 102, 0, 204, 255, 153, 255, 25, 76, 127, 204};
  for (const double x : {-0.9, 0.9}) {
    Object object;
    object.mesh = std::make_shared<const Mesh>(sphere_mesh(24, 12));
    object.position = {x, 0.1, 0};
    object.material.fragment_function = refraster::Minnaert{.kd = {0.9, 0.8, 0.7}, .darkening = x < 0 ? 1.0 : 2.25};
    object.material.diffuse_map.texture = texture;
    scene.objects.push_back(object);
  }
  return scene;
}

/// The same, each ball by the function that is compiled outside.
Scene by_user(Scene scene) {
  for (Object& object : scene.objects) {
    const auto& moon = std::get<refraster::Minnaert>(object.material.fragment_function);
    object.material.user_function =
        user_function(moon::Minnaert{.ka = moon.ka, .kd = moon.kd, .darkening = moon.darkening});
    object.material.fragment_function = {};
  }
  return scene;
}

} // namespace

TEST_CASE("the list and the random scenes have it") {
  const auto is_minnaert = [](const FragmentFunction& function) {
    return std::holds_alternative<refraster::Minnaert>(function);
  };
  const std::vector<FragmentFunction> each = each_fragment_function();
  CHECK(std::count_if(each.begin(), each.end(), is_minnaert) == 1);
  int objects = 0, minnaert = 0, within = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Random random(seed);
    for (const Object& object : test::random_scene(random).objects) {
      ++objects;
      const auto* const moon = std::get_if<refraster::Minnaert>(&object.material.fragment_function);
      minnaert += moon != nullptr;
      within += moon && moon->darkening >= 1;
    }
  }
  CHECK(minnaert * 8 > objects); // one of four
  CHECK(within == minnaert);
}

TEST_CASE("it gives the bits of the same function from outside, in every precision, with AOVs") {
  const Scene listed = moons();
  test::check_same_frames(by_user(listed), listed, [](const Frame&) {});
}

TEST_CASE("and its bounds") {
  const Scene listed = moons();
  test::check_same_bounds(by_user(listed), listed);
}

TEST_CASE("the slow renderer's pixels with the formula in long double are those of double") {
  const Scene scene = moons();
  RenderOptions options{.width = 96, .height = 72, .threads = 2};
  options.want_radiance_double = true;
  const Frame frame = render(scene, options);
  std::vector<slow::Pixel> pixels;
  for (int y = 2; y < options.height; y += 5)
    for (int x = 3; x < options.width; x += 5) pixels.push_back({x, y});
  const auto seen = slow::seen_at(scene, options.width, options.height, pixels);
  int judged = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (!seen[i] || !seen[i]->object) continue;
    ++judged;
    const auto& moon = std::get<refraster::Minnaert>(seen[i]->object->material.fragment_function);
    const slow::Lit at = slow::lit(scene, *seen[i]);
    slow::Vec radiance = slow::vec(moon.ka) * at.texture, peak = slow::vec(moon.ka);
    for (const slow::Arriving& light : at.lights) {
      const slow::Vec full = slow::vec(moon.kd) * light.radiance;
      const slow::Real n_l = std::max(dot(at.normal, light.direction), slow::Real(0));
      const slow::Real n_v = std::max(dot(at.normal, at.to_eye), slow::Real(0));
      radiance = radiance + full * at.texture * (n_l * std::pow(n_l * n_v, slow::real(moon.darkening) - 1));
      peak = peak + full;
    }
    // tests/system/scenes/test_colours.cpp derives 2^-30 of what was added up for scenes wilder than this one.
    const auto near = [](double found, slow::Real expected, slow::Real size) {
      return std::abs(slow::real(found) - expected) <= 0x1p-30L * size;
    };
    const double* const found = frame.radiance_double.at(pixels[i].x, pixels[i].y);
    CAPTURE(pixels[i].x);
    CAPTURE(pixels[i].y);
    CHECK(near(found[0], radiance.x, peak.x));
    CHECK(near(found[1], radiance.y, peak.y));
    CHECK(near(found[2], radiance.z, peak.z));
  }
  CHECK(judged >= 40);
}

TEST_CASE("without a formula of its own the slow renderer refuses it by name") {
  const Scene scene = moons();
  slow::Seen seen;
  seen.object = scene.objects.data(), seen.material = &scene.objects[0].material;
  CHECK_THROWS_WITH_AS(slow::shaded(scene, seen), "slow_shading.cpp has no formula of minnaert", std::logic_error);
}

TEST_CASE("a scene file may name it, and its documentation lists it") {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "refraster_variant";
  std::filesystem::create_directories(folder);
  const std::string text = R"({"scene": {
    "camera": {"position": "0 0 4", "fov_y": 40}, "point_lights": [],
    "direction_lights": [{"direction": "-1 -1 -1", "radiance": "1 1 1"}],
    "objects": [{"mesh": {"sphere": {}}, "fragment_function": "minnaert", "position": "0 0 0", "rotate_x": 0,
      "rotate_y": 0, "rotate_z": 0, "scale": "1 1 1",
      "material": {"ka": "0.05 0.05 0.05", "kd": "1 1 1", "darkening": 2}}]}})";
  std::ofstream(folder / "moon.json") << text;
  const Scene scene = read_scene(folder / "moon.json");
  REQUIRE(scene.objects.size() == 1);
  const auto* const moon = std::get_if<refraster::Minnaert>(&scene.objects[0].material.fragment_function);
  REQUIRE(moon);
  CHECK(moon->darkening == 2);
  CHECK(scene_format_markdown().find("darkening") != std::string::npos);
}
