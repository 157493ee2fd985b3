// refraster turntable: frames, going on, films.

#include <refraster/files.h>
#include <refraster/scene.h>

#include "app/turntable/frame_names.h"
#include "app/turntable/orbit.h"
#include "io/scene/path/camera_path.h"
#include "math/vec.h"
#include "tests/support/emulated.h"
#include "tests/support/program/program.h"
#include "tests/support/program/scenes.h"

#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include <sys/wait.h>

namespace refraster {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> small = {"--size", "40x30"};

struct Table : TemporaryFolder {
  Table() { save_text(*this / "s.json", ball_scene); }

  Finished run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"turntable", "s.json"});
    arguments.insert(arguments.end(), small.begin(), small.end());
    return run_program(path, arguments);
  }
  std::string frame(int number) const { return text_of(*this / "out/000" + std::to_string(number) + ".png"); }
};

} // namespace

TEST_CASE("cameras of a whole turn: the first is the scene's, all are as far from the target and from its plane") {
  Camera start;
  start.position = {1, 2, 5}, start.target = {1, 0, 1}, start.up = {0, 3, 0};
  const std::vector<Camera> cameras = orbit(start, 8);
  REQUIRE(cameras.size() == 8);
  CHECK(cameras[0].position == start.position);
  // A quarter turn, counter-clockwise from above: +z comes to +x.
  CHECK(length(cameras[2].position - Double3(5, 2, 1)) < 1e-14);
  CHECK(length(cameras[4].position - Double3(1, 2, -3)) < 1e-14);
  for (const Camera& camera : cameras) {
    CHECK(length(camera.position - camera.target) == doctest::Approx(length(start.position - start.target)));
    CHECK(camera.position.y == doctest::Approx(2));
    CHECK(camera.up == start.up);
  }
}

TEST_CASE("a name of frames has one run of #, in its last part") {
  CHECK(FrameNames::of("out/####.png")->name(0) == "out/0001.png");
  CHECK(FrameNames::of("a_##.png")->name(99) == "a_100.png");
  CHECK(FrameNames::of("out/####.png")->report_name() == "out/turntable.json");
  CHECK(FrameNames::of("out/ball_####.png")->report_name() == "out/ball.json");
  for (const char* const wrong : {"a.png", "#/a.png", "#a#.png", ""}) CHECK_FALSE(FrameNames::of(wrong));
}

TEST_CASE("frames are those that render makes; a second run makes none again, and mends what is missing or changed") {
  const Table table;
  const Finished first = table.run({"-o", "out/####.png", "--frames", "4"});
  CHECK(first.exit_code == 0);
  CHECK(first.out == "out/0001.png\nout/0002.png\nout/0003.png\nout/0004.png\n");
  REQUIRE(run_program(table.path, {"render", "s.json", "-o", "one.png", "--size", "40x30"}).exit_code == 0);
  CHECK(table.frame(1) == text_of(table / "one.png"));
  CHECK(table.frame(1) != table.frame(2));
  const std::string second_frame = table.frame(2), third_frame = table.frame(3);

  fs::remove(table / "out/0002.png");
  save_text(table / "out/0003.png", third_frame.substr(0, 100));
  const auto untouched = fs::last_write_time(table / "out/0004.png");
  const Finished again = table.run({"-o", "out/####.png", "--frames", "4"});
  CHECK(again.exit_code == 0);
  CHECK(again.err == "note: 2 of 4 frames are there, as out/turntable.json says, and are not made again\n");
  CHECK(table.frame(2) == second_frame);
  CHECK(table.frame(3) == third_frame);
  CHECK(fs::last_write_time(table / "out/0004.png") == untouched);
}

TEST_CASE("another option, and another scene, begin anew") {
  const Table table;
  REQUIRE(table.run({"-o", "out/####.png", "--frames", "2"}).exit_code == 0);
  const std::string linear = table.frame(2);
  const Finished curved = table.run({"-o", "out/####.png", "--frames", "2", "--srgb"});
  CHECK(curved.err.empty());
  const std::string encoded = table.frame(2);
  CHECK(encoded != linear);
  // Options that change what no other file has.
  for (const std::vector<std::string>& change :
       {std::vector<std::string>{"--exposure", "1"}, {"--background", "0.5,0.5,0.5"},
        {"--set", "/scene/point_lights/0/radiance=[9, 9, 9]"}, {"--set", "/scene/objects/0/scale=\"1 2 1\""}}) {
    std::vector<std::string> words = {"-o", "out/####.png", "--frames", "2", "--srgb"};
    words.insert(words.end(), change.begin(), change.end());
    const Finished other = table.run(words);
    INFO(change[1]);
    CHECK(other.exit_code == 0);
    CHECK(other.err.empty());
    CHECK(table.frame(2) != encoded);
    REQUIRE(table.run({"-o", "out/####.png", "--frames", "2", "--srgb"}).err.empty());
  }
  std::string brighter = ball_scene;
  brighter.replace(brighter.find("[8, 8, 8]"), 9, "[9, 9, 9]");
  save_text(table / "s.json", brighter);
  const Finished changed = table.run({"-o", "out/####.png", "--frames", "2", "--srgb"});
  CHECK(changed.err.empty());
  CHECK(table.frame(2) != encoded);
}

TEST_CASE("a mesh that a scene names is part of it") {
  const Table table;
  save_text(table / "s.json", ball_from_file());
  write_obj(table / "m.obj", cube_mesh());
  REQUIRE(table.run({"-o", "out/####.png", "--frames", "2"}).exit_code == 0);
  const std::string cube = table.frame(2);
  write_obj(table / "m.obj", sphere_mesh(8, 6));
  const Finished changed = table.run({"-o", "out/####.png", "--frames", "2"});
  CHECK(changed.exit_code == 0);
  CHECK(changed.err.empty());
  CHECK(table.frame(2) != cube);
}

TEST_CASE("a path of cameras: one a frame; what is wrong is said with its place") {
  const Table table;
  save_text(table / "path.json", R"([{"position": [0, 1, 4], "target": [0, 0, 0]},
                                     {"position": [2, 1, 4], "target": [0, 0, 0], "fov_y": 60}])");
  const Finished done = table.run({"-o", "out/####.png", "--camera-path", "path.json"});
  CHECK(done.exit_code == 0);
  CHECK(done.out == "out/0001.png\nout/0002.png\n");
  REQUIRE(run_program(table.path, {"render", "s.json", "-o", "one.png", "--size", "40x30"}).exit_code == 0);
  CHECK(table.frame(1) == text_of(table / "one.png")); // fov_y is the scene's

  save_text(table / "path.json", R"([{"target": [0, 0, 0]}, 7])");
  const Finished wrong = table.run({"-o", "out/####.png", "--camera-path", "path.json"});
  CHECK(wrong.exit_code == 3);
  CHECK(wrong.err.find("path.json:1:2: /0/position: found nothing, expected three numbers") != std::string::npos);
  CHECK(wrong.err.find("path.json:1:25: /1: found 7, expected an object: a camera") != std::string::npos);
  save_text(table / "path.json", "{}");
  CHECK(table.run({"-o", "out/####.png", "--camera-path", "path.json"}).err.find("expected a list of cameras") !=
        std::string::npos);
}

TEST_CASE("usage: an output without a place for numbers, and bits that the format has not") {
  const Table table;
  CHECK(table.run({"-o", "out.png"}).exit_code == 2);
  CHECK(table.run({"-o", "##.jpg", "--bits", "16"}).exit_code == 2);
  CHECK(table.run({}).exit_code == 2);
}

TEST_CASE("a film by ffmpeg, with the digests of its frames; without ffmpeg a line says so") {
  const Table table;
  const bool has_ffmpeg = std::system("ffmpeg -version >/dev/null 2>&1") == 0;
  const Finished done = table.run({"-o", "turn.mp4", "--frames", "3"});
  if (!has_ffmpeg) {
    MESSAGE("ffmpeg is not installed (scripts/setup film)");
    CHECK(done.exit_code == 4);
    CHECK(done.err.find("turn.mp4: cannot write: a film is made by ffmpeg, which is not installed") != std::string::npos);
    return;
  }
  CHECK(done.exit_code == 0);
  CHECK(done.out == "turn.mp4\n");
  CHECK(text_of(table / "turn.mp4").substr(4, 4) == "ftyp");
  CHECK(text_of(table / "turn.mp4.json").find("\"sha256\": null") == std::string::npos);
  CHECK(files_in(table) == std::vector<std::string>{"s.json", "turn.mp4", "turn.mp4.json"});
  if (test::skipped_in_emulator(test::no_failure_of_spawn)) return;
  // With a PATH on which there is none.
  const std::string nowhere = "PATH=" + table.path.string() + " " + program_command() + " turntable " + table / "s.json" +
                              " --size 4x4 -o " + table / "x.mp4" + " 2>" + table / "err";
  CHECK(WEXITSTATUS(std::system(nowhere.c_str())) == 4);
  CHECK(text_of(table / "err").find("which is not installed") != std::string::npos);
}

TEST_CASE("interrupted, it leaves whole frames, and goes on with the rest") {
  const Table table;
  Running running(table.path, {"turntable", "s.json", "-o", "out/####.png", "--frames", "400", "--size", "640x480"});
  for (int tries = 0; tries < 6000 && !fs::exists(table / "out/0003.png"); ++tries)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  running.send(SIGINT);
  const Finished stopped = running.wait();
  CHECK(stopped.exit_code == 130);
  std::size_t frames = 0;
  for (const auto& entry : fs::directory_iterator(table / "out"))
    if (entry.path().extension() == ".png") {
      CHECK(read_image(entry.path()).values.width == 640);
      ++frames;
    }
  CHECK(frames >= 3);
  CHECK(frames < 400);
}

} // namespace refraster
