// What the key P writes, and what keys change: the same as the words of a command line say.

#include "app/options/parse.h"
#include "app/view/settings.h"
#include "app/view/snapshot.h"
#include "tests/support/program/program.h"
#include "tests/support/program/scenes.h"
#include "tests/support/random.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace refraster;

namespace {

struct Folder {
  TemporaryFolder folder;
  std::string scene = folder.path / "it's a ball.json";
  Folder() { save_text(scene, ball_scene); }
};

Scene read(const std::string& path, const std::vector<SceneEdit>& edits) {
  return read_scene_source(path, {}, edits).placed(64, 48);
}

} // namespace

TEST_CASE("the camera's JSON reads back as the same camera, bit for bit") {
  const Folder f;
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const auto number = [&] { return std::ldexp(random.below(1 << 30) - (1 << 29), random.below(40) - 50); };
    const Camera camera{.position = {number(), number(), number()},
                        .target = {number(), number(), number() + 1},
                        .up = {0.1, 1, 1.0 / 3},
                        .fov_y_degrees = 1 + random.below(1000) / 7.0,
                        .near = 1.0 / (3 + random.below(50)),
                        .far = 3 + random.below(9) / 7.0};
    const Camera back = read(f.scene, {{"/scene/camera", camera_json(camera), "--set"}}).camera;
    CHECK(back.position == camera.position);
    CHECK(back.target == camera.target);
    CHECK(back.up == camera.up);
    CHECK(back.fov_y_degrees == camera.fov_y_degrees);
    CHECK(back.near == camera.near);
    CHECK(back.far == camera.far);
  }
}

TEST_CASE("settings change a scene as their edits change its text") {
  const Folder f;
  const Scene own = read(f.scene, {});
  for (const ShadowsShown shadows : {ShadowsShown::of_scene, ShadowsShown::all, ShadowsShown::none})
    for (const std::set<std::size_t>& dark : {std::set<std::size_t>{}, {0}, {1}, {0, 1}}) {
      ViewSettings settings;
      settings.shadows = shadows, settings.dark_lights = dark;
      Scene changed = own;
      apply(settings, changed);
      const Scene by_text = read(f.scene, scene_edits(settings, own));
      CHECK(changed.point_lights[0].radiance == by_text.point_lights[0].radiance);
      CHECK(changed.point_lights[0].shadow.kind == by_text.point_lights[0].shadow.kind);
      CHECK(changed.point_lights[0].shadow.map == by_text.point_lights[0].shadow.map);
      CHECK(changed.direction_lights[0].radiance == by_text.direction_lights[0].radiance);
      CHECK(changed.direction_lights[0].shadow.kind == by_text.direction_lights[0].shadow.kind);
      CHECK(changed.direction_lights[0].shadow.map == by_text.direction_lights[0].shadow.map);
      CHECK((changed.point_lights[0].radiance == Double3(0)) == dark.contains(0));
      CHECK((changed.direction_lights[0].radiance == Double3(0)) == dark.contains(1));
    }
  CHECK(light_name(own, 0) == "point light 0");
  CHECK(light_name(own, 1) == "direction light 0");
  CHECK(light_name(own, 2).empty());
  CHECK(switched(ShadowsShown::of_scene, own) == ShadowsShown::all);
  CHECK(switched(ShadowsShown::all, own) == ShadowsShown::of_scene);
  Scene shadowed = own;
  shadowed.point_lights[0].shadow = Shadow::exact;
  CHECK(switched(ShadowsShown::of_scene, shadowed) == ShadowsShown::none);
}

TEST_CASE("a key does what it says, says what it does, and pressed again undoes it") {
  const Folder f;
  const Scene own = read(f.scene, {});
  ViewSettings settings;
  CHECK(change(settings, KeyAction::light, "1", own) == "point light 0 off");
  CHECK(settings.dark_lights == std::set<std::size_t>{0});
  CHECK(change(settings, KeyAction::light, "1", own) == "point light 0 on");
  CHECK(change(settings, KeyAction::light, "3", own) == "there is no light 3");
  CHECK(change(settings, KeyAction::shadows, "O", own) == "shadows: of all lights");
  CHECK(change(settings, KeyAction::shadows, "O", own) == "shadows: as the scene says");
  CHECK(change(settings, KeyAction::edges, "E", own) == "");
  CHECK(change(settings, KeyAction::edges, "E", own) == "");
  CHECK(settings == ViewSettings{});
  CHECK(change(settings, KeyAction::precision, "N", own) == "precision: float");
  CHECK_FALSE(change(settings, KeyAction::help, "H", own));
}

TEST_CASE("precisions and AOVs go round") {
  Precision precision = Precision::double_;
  for (std::size_t i = 0; i < std::size(EnumNames<Precision>::names); ++i) precision = next_precision(precision);
  CHECK(precision == Precision::double_);
  std::optional<Aov> aov;
  for (std::size_t i = 0; i < std::size(aov_kinds); ++i) CHECK((aov = next_aov(aov)));
  CHECK_FALSE(next_aov(aov));
}

TEST_CASE("the words are those of `refraster render`, with what the run was given, but for its camera") {
  PictureRun run;
  run.scene = "a scene.json", run.output = "a-001.png", run.size = {64, 48}, run.samples = 4;
  run.transfer = Transfer::srgb, run.precision = "float", run.files.aovs = {Aov::depth};
  run.reading.outside = Outside::allowed, run.reading.exposure_stops = 0.1;
  run.changes.view = {{"/scene/camera/position", "", "--camera"}};
  run.changes.values = {{"/scene/camera/fov_y", "30", "--fov"}, {"/scene/background", "[1, 1, 1]", "--background"}};
  run.changes.set = {{"/scene/cameras", "1", "--set"}};
  const std::vector<std::string> words =
      render_words("refraster", run, {{"/scene/point_lights/0/radiance", "[0, 0, 0]", "--set"}}, Camera{});
  CHECK(
      shell_line(words) ==
      "refraster render 'a scene.json' --size 64x48 --samples 4 --srgb --precision float --allow-outside --exposure "
      "0.1 --aov depth --set '/scene/background=[1, 1, 1]' --set '/scene/cameras=1' --set "
      "'/scene/point_lights/0/radiance=[0, 0, 0]' --set '/scene/camera={\"position\": [0.0, 0.0, 0.0], \"target\": "
      "[0.0, 0.0, -1.0], \"up\": [0.0, 1.0, 0.0], \"fov_y\": 45.0, \"near\": 0.1, \"far\": 100.0}' --output a-001.png");
  const Command program = refraster_command();
  CHECK_NOTHROW(action_of(named_command(program, {words.begin() + 1, words.end()})));
}

TEST_CASE("no file that is there is written over: one of the three is enough") {
  const TemporaryFolder folder;
  const FrameNames names = FrameNames::of((folder.path / "ball-##.png").string()).value();
  CHECK(unused_files(names).image == folder.path / "ball-01.png");
  CHECK(unused_files(names).camera == folder.path / "ball-01.camera.json");
  CHECK(unused_files(names).script == folder.path / "ball-01.sh");
  save_text(folder.path / "ball-01.png", "");
  save_text(folder.path / "ball-02.sh", "");
  std::filesystem::create_symlink("nowhere", folder.path / "ball-03.camera.json");
  CHECK(unused_files(names).image == folder.path / "ball-04.png");
}

TEST_CASE("the script makes what the command makes, from any folder and under any name") {
  const Folder f;
  const std::filesystem::path folder = f.folder.path;
  const std::string words_file = folder / "words";
  save_text(words_file, "");
  // In the place of the program: one that prints its words.
  const std::string printer = folder / "print words";
  save_text(printer, "#!/bin/sh\npwd >> words\nprintf '%s\\n' \"$@\" >> words\n");
  std::filesystem::permissions(printer, std::filesystem::perms::owner_all);
  const std::string script = folder / "script.sh";
  save_text(script, shell_script({printer, "render", "it's.json", "--set", "/a=\"$x `y`\"", "--output", "a b.png"},
                                 std::filesystem::canonical(folder)));
  REQUIRE(std::system(("cd / && sh '" + script + "' && sh '" + script + "' 'other name.png'").c_str()) == 0);
  const std::string here = std::filesystem::canonical(folder).string() + "\n";
  const std::string before = "render\nit's.json\n--set\n/a=\"$x `y`\"\n--output\n";
  CHECK(text_of(words_file) == here + before + "a b.png\n" + here + before + "other name.png\n");
}
