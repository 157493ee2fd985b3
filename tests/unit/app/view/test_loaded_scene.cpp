// A scene as the window reads it, and as it is seen.

#include "app/options/scene_options.h"
#include "app/view/loaded_scene.h"
#include "math/vec.h"
#include "tests/support/files/malformed_inputs.h"
#include "tests/support/files/png_bytes.h"
#include "tests/support/program/scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace refraster;
using test::TemporaryFolder;

namespace {

const std::string triangle = "mtllib m.mtl\nv 0 0 0\nv 2 0 0\nv 2 2 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n";
const std::string library = "newmtl a\nKd 1 1 1\nmap_Kd t.png\n";
const std::string grey_pixel = test::png_bytes(2, 2, 1, 8, {1, 2, 3, 4});
const Size small{64, 48};

/// What the scene at this path depends on, by the names in its folder; also if it cannot be read.
std::set<std::string> files_of(const std::string& path, bool* is_read = nullptr) {
  PictureRun run;
  run.scene = path, run.diagnostics.verbosity = Verbosity::quiet;
  LoadedScene loaded;
  bool read = true;
  try {
    load(run, std::nullopt, loaded);
  } catch (const InputError&) {
    read = false;
  }
  if (is_read) *is_read = read;
  std::set<std::string> names;
  for (const std::string& file : loaded.files) names.insert(std::filesystem::path(file).filename());
  return names;
}

LoadedScene load_text(const std::string& text) {
  const TemporaryFolder folder;
  test::write_files(folder.path, {{"s.json", text}});
  PictureRun run;
  run.scene = folder / "s.json";
  LoadedScene loaded;
  load(run, std::nullopt, loaded);
  return loaded;
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

} // namespace

TEST_CASE("a scene depends on its file, meshes, materials, textures and GLSL, whether they can be read or not") {
  const TemporaryFolder folder;
  const std::string scene =
      with(ball_from_file(), "\"fragment_function\": \"phong\"",
           "\"vertex_shader_file_path\": \"v.glsl\", \"fragment_shader_file_path\": \"phong.glsl\"");
  test::write_files(folder.path, {{"m.obj", triangle}, {"m.mtl", library}, {"t.png", grey_pixel}, {"s.json", scene}});
  CHECK(files_of(folder / "m.obj") == std::set<std::string>{"m.obj", "m.mtl", "t.png"});
  const std::set<std::string> all = {"s.json", "m.obj", "v.glsl", "phong.glsl"}, read_before = {"s.json", "m.obj"};
  bool is_read = false;
  CHECK(files_of(folder / "s.json", &is_read) == all);
  CHECK(is_read);
  test::write_files(folder.path, {{"m.obj", "v 0 0 x\n"}});
  CHECK(files_of(folder / "s.json", &is_read) == read_before);
  CHECK_FALSE(is_read);
  std::filesystem::remove(folder.path / "m.obj");
  CHECK(files_of(folder / "s.json", &is_read) == read_before);
  CHECK_FALSE(is_read);
  test::write_files(folder.path, {{"s.json", "{"}});
  CHECK(files_of(folder / "s.json", &is_read) == std::set<std::string>{"s.json"});
  CHECK_FALSE(is_read);
}

TEST_CASE("how fast the camera moves is what the scene says, or follows from how large the scene is") {
  const MotionRates said = rates_of(
      load_text(with(ball_scene, "\"fov_y\": 40", "\"movement_speed\": 5, \"mouse_sensitivity\": -0.25")), small);
  CHECK(said.speed == 5);
  CHECK(said.look_degrees == -0.25);
  CHECK(said.turn_degrees == 360.0 / 64);
  const LoadedScene loaded = load_text(ball_scene);
  const MotionRates own = rates_of(loaded, small);
  CHECK(own.speed == length(loaded.source.scene.camera.position - loaded.ball.centre) / 2);
  CHECK(own.look_degrees == 0.1);
  CHECK(rates_of(load_text(empty_scene), small).speed == 2.5); // half of the way to the origin
}

TEST_CASE("the ball holds every vertex in the world") {
  const LoadedScene loaded = load_text(ball_scene); // a sphere of radius 1, a plane from -3 to 3 turned by 30 degrees
  CHECK(length(loaded.ball.centre - Double3(0, 0, 0)) <= 1e-6);
  CHECK(loaded.ball.radius == doctest::Approx(std::sqrt(19))); // to a corner, (3, -1, 3)
  CHECK(load_text(empty_scene).ball.radius == 0);
}

TEST_CASE("a camera that was not moved is the scene's own, bit for bit; one that was has planes around what there is") {
  const std::string fitted = with(ball_scene, "\"position\": \"0 1 4\", \"target\": \"0 0 0\"", "\"fit\": {}");
  const LoadedScene loaded = load_text(fitted);
  const Scene own = SceneSource(loaded.source).placed(small.width, small.height);
  const Camera camera = seen(loaded, {}, {}, small).camera;
  CHECK(same_camera(camera, own.camera));
  Camera moved = movable(loaded, camera);
  CHECK(moved.up == Double3(0, 1, 0)); // and not across the view, as that of the fit
  follow(loaded, moved);
  CHECK(moved.near < camera.near); // a ball is larger than what it holds
  CHECK(moved.far > camera.far);
  CHECK(same_camera(seen(loaded, moved, {}, small).camera, moved));

  const LoadedScene standing = load_text(ball_scene);
  Camera stays = movable(standing, seen(standing, {}, {}, small).camera);
  follow(standing, stays);
  CHECK(same_camera(stays, standing.source.scene.camera)); // whose planes are its own
}

TEST_CASE("a camera that looks along its up vector is moved by the up vector of its picture") {
  const LoadedScene above = load_text(with(ball_scene, "\"position\": \"0 1 4\", \"target\": \"0 0 0\"",
                                           "\"fit\": {\"elevation\": 90, \"azimuth\": 0}"));
  const Camera camera = movable(above, seen(above, {}, {}, small).camera);
  CHECK(can_be_moved(camera));
}

TEST_CASE("lights of camera space move with a camera that was moved") {
  const LoadedScene loaded =
      load_text(with(ball_scene, "\"quadratic\": 0.2", "\"quadratic\": 0.2, \"space\": \"camera\""));
  Camera camera = loaded.source.scene.camera;
  camera.position = {0, 0, 10}, camera.target = {0, 0, 0};
  CHECK(seen(loaded, camera, {}, small).point_lights[0].position == Double3(2, 3, 14));
}

TEST_CASE("whether the scene's own camera has changed does not depend on what else has") {
  const LoadedScene one = load_text(ball_scene);
  CHECK(same_own_camera(one, load_text(with(ball_scene, "0.1 0.2 0.3", "1 1 1"))));
  CHECK_FALSE(same_own_camera(one, load_text(with(ball_scene, "\"fov_y\": 40", "\"fov_y\": 41"))));
  const std::string place = "\"position\": \"0 1 4\", \"target\": \"0 0 0\"";
  const LoadedScene fitted = load_text(with(ball_scene, place, "\"fit\": {}"));
  CHECK_FALSE(same_own_camera(one, fitted));
  CHECK_FALSE(same_own_camera(fitted, load_text(with(ball_scene, place, "\"fit\": {\"azimuth\": 31}"))));
}

TEST_CASE("a fragment function for all objects is read as --fragment-function is") {
  const TemporaryFolder folder;
  test::write_files(folder.path, {{"s.json", ball_scene}});
  PictureRun run;
  run.scene = folder / "s.json";
  LoadedScene loaded;
  const std::vector<std::string> names = fragment_function_names();
  const auto phong = static_cast<std::size_t>(std::find(names.begin(), names.end(), "phong") - names.begin());
  load(run, phong, loaded);
  for (const Object& object : loaded.source.scene.objects) CHECK(object.material.function_name() == "phong");
}
