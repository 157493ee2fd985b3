// refraster render

#include <refraster/files.h>

#include "tests/support/program/program.h"
#include "tests/support/program/scenes.h"

#include <doctest/doctest.h>

#include <csignal>
#include <thread>

using namespace refraster;

namespace {

using Words = std::vector<std::string>;

/// A folder with ball.json in it.
struct BallFolder : TemporaryFolder {
  BallFolder() { save_text(*this / "ball.json", ball_scene); }

  /// Renders and gives the bytes of the image.
  std::string rendered(const std::string& output, Words more) const {
    Words words = {"render", "ball.json", "-o", output, "--size", "90x70"};
    words.insert(words.end(), more.begin(), more.end());
    const Finished run = run_program(path, words);
    REQUIRE_MESSAGE(run.exit_code == 0, run.err);
    return text_of(*this / output);
  }
};

} // namespace

TEST_CASE("the image goes to the current directory under the scene's name, and its path to standard output") {
  const BallFolder folder;
  const Finished run = run_program(folder.path, {"render", "ball.json", "--size", "16x9"});
  CHECK(run.exit_code == 0);
  CHECK(run.out == "ball.png\n");
  CHECK(run.err.empty()); // no progress: not a terminal
  CHECK(files_in(folder) == Words{"ball.json", "ball.png"});
}

TEST_CASE("every format is written") {
  const BallFolder folder;
  CHECK(folder.rendered("a.png", {}).starts_with("\x89PNG"));
  CHECK(folder.rendered("a.hdr", {}).starts_with("#?RADIANCE"));
  CHECK(folder.rendered("a.pfm", {}).starts_with("PF\n90 70\n"));
  CHECK(folder.rendered("a.EXR", {}).starts_with("\x76\x2f\x31\x01"));
}

TEST_CASE("an empty scene shows the background, to the nearest level") {
  const TemporaryFolder folder;
  save_text(folder / "empty.json", empty_scene);
  REQUIRE(run_program(folder.path, {"render", "empty.json", "--size", "3x2"}).exit_code == 0);
  const auto image = read_image(folder / "empty.png").values;
  REQUIRE(image.width == 3);
  REQUIRE(image.height == 2);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 3; ++x) {
      CHECK(image.at(x, y)[0] == 51);  // 0.2 * 255
      CHECK(image.at(x, y)[1] == 102); // 0.4
      CHECK(image.at(x, y)[2] == 153); // 0.6
    }
}

TEST_CASE("the same bytes for every number of threads and every tile size") {
  const BallFolder folder;
  for (const char* const precision : {"double", "float"}) {
    const std::string one = folder.rendered("one.pfm", {"--precision", precision, "--threads", "1"});
    for (const char* threads : {"2", "3", "7"})
      CHECK(folder.rendered("many.pfm", {"--precision", precision, "--threads", threads}) == one);
    for (const char* tile_size : {"8", "16", "32", "128"})
      CHECK(folder.rendered("tile.pfm", {"--precision", precision, "--tile-size", tile_size}) == one);
  }
}

TEST_CASE("a crop is that part of the full image, to the byte") {
  const BallFolder folder;
  folder.rendered("full.png", {});
  const auto full = read_image(folder / "full.png").values;
  struct Part {
    int x, y, width, height;
  };
  for (const Part part : {Part{0, 0, 90, 70}, Part{13, 7, 40, 41}, Part{89, 69, 1, 1}, Part{0, 33, 90, 3}}) {
    const std::string text = std::to_string(part.x) + "," + std::to_string(part.y) + "," + std::to_string(part.width) +
                             "," + std::to_string(part.height);
    folder.rendered("crop.png", {"--crop", text});
    const auto crop = read_image(folder / "crop.png").values;
    REQUIRE(crop.width == part.width);
    REQUIRE(crop.height == part.height);
    int different = 0;
    for (int y = 0; y < crop.height; ++y)
      for (int x = 0; x < crop.width; ++x)
        for (int c = 0; c < 3; ++c) different += crop.at(x, y)[c] != full.at(part.x + x, part.y + y)[c];
    CHECK_MESSAGE(different == 0, text);
  }
}

TEST_CASE("AOVs stand next to the image, as .exr beside .exr and else as .pfm") {
  const BallFolder folder;
  const Words all = {"--aov", "depth,normal,position,uv,albedo,triangle,object"};
  folder.rendered("a.png", all);
  for (const char* name : {"depth", "normal", "position", "uv", "albedo", "triangle", "object"})
    CHECK(text_of(folder / ("a." + std::string(name) + ".pfm")).starts_with("P"));
  folder.rendered("b.exr", {"--aov", "depth,uv"});
  CHECK(text_of(folder / "b.depth.exr").starts_with("\x76\x2f\x31\x01"));
  CHECK(text_of(folder / "b.uv.exr").starts_with("\x76\x2f\x31\x01"));
}

TEST_CASE("all paths written are printed, one a line") {
  const BallFolder folder;
  const Finished run = run_program(folder.path, {"render", "ball.json", "--size", "8x8", "--aov", "object,depth"});
  CHECK(run.out == "ball.png\nball.object.pfm\nball.depth.pfm\n");
}

TEST_CASE("--srgb changes the image") {
  const BallFolder folder;
  CHECK(folder.rendered("a.png", {}) != folder.rendered("b.png", {"--srgb"}));
}

TEST_CASE("the report names scene, build and counts; on standard output it stands alone") {
  const BallFolder folder;
  folder.rendered("a.png", {"--report", "a.json", "--threads", "1"});
  const std::string report = text_of(folder / "a.json");
  for (const std::string part :
       {"\"scene\": \"ball.json\"", "\"size\": [90, 70]", "\"precision\": \"double\"", "\"threads\": 1",
        "\"compiler\":", "-ffp-contract=off -fno-fast-math", "\"in_scene\": 536", "\"in_image\": 6300",
        "\"zero_normal\": 0", "\"occupancy\":", "\"outputs\": [\"a.png\"]"})
    CHECK_MESSAGE(report.find(part) != std::string::npos, part << "\n" << report);
  const Finished run = run_program(folder.path, {"render", "ball.json", "--size", "8x8", "--report", "-"});
  CHECK(run.out.starts_with("{\n"));
  CHECK(run.out.ends_with("}\n"));
}

TEST_CASE("bad input is exit code 3: not there, a folder, empty, not a scene") {
  const BallFolder folder;
  save_text(folder / "empty.json", "");
  save_text(folder / "broken.json", "{\"camera\": ");
  for (const char* scene : {"none.json", ".", "empty.json", "broken.json", ""}) {
    const Finished run = run_program(folder.path, {"render", scene, "-o", "x.png"});
    INFO(scene << "\n" << run.err);
    CHECK(run.exit_code == 3);
    CHECK(run.out.empty());
    CHECK_FALSE(run.err.empty());
  }
  CHECK(files_in(folder) == Words{"ball.json", "broken.json", "empty.json"});
}

TEST_CASE("an output that cannot be written is exit code 4, before any work") {
  const BallFolder folder;
  std::filesystem::create_directory(folder / "folder.png");
  save_text(folder / "file", "");
  const std::vector<Words> unwritable = {{"-o", "no/such/folder/a.png"},
                                         {"-o", "folder.png"},
                                         {"-o", "file/a.png"},
                                         {"--report", "none/a.json"},
                                         {"-o", "/proc/a.png"}};
  for (const Words& words : unwritable) {
    // At the largest size this would take seconds and gigabytes, if it were begun.
    Words all = {"render", "ball.json", "--size", "16384x16384"};
    all.insert(all.end(), words.begin(), words.end());
    const Finished run = run_program(folder.path, all);
    INFO(words.back() << "\n" << run.err);
    CHECK(run.exit_code == 4);
    CHECK(run.out.empty());
  }
  CHECK(files_in(folder) == Words{"ball.json", "file", "folder.png"});
}

TEST_CASE("a signal ends the run with 130 and leaves nothing behind") {
  const BallFolder folder;
  Running run(folder.path, {"render", "ball.json", "--size", "8192x8192", "--threads", "1"});
  std::this_thread::sleep_for(std::chrono::milliseconds(300)); // far less than such a frame takes
  run.send(SIGINT);
  const Finished end = run.wait();
  CHECK(end.exit_code == 130);
  CHECK(end.out.empty());
  CHECK(files_in(folder) == Words{"ball.json"});
}

TEST_CASE("with a cache a large mesh is read from it the second time, and the image is the same") {
  const TemporaryFolder folder;
  // Comments make it large: a mesh is kept from 1 MiB on.
  save_text(folder / "m.obj", std::string(std::size_t{1} << 20, '#') + "\nv -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n");
  std::string scene = ball_scene;
  const std::string sphere = R"("mesh": {"sphere": {"segments": 24, "rings": 12}})";
  scene.replace(scene.find(sphere), sphere.size(), R"("obj_file_path": "m.obj")");
  save_text(folder / "s.json", scene);
  const auto rendered = [&](Words more) {
    Words words = {"render", "s.json", "-o", "s.png", "--size", "90x70"};
    words.insert(words.end(), more.begin(), more.end());
    const Finished run = run_program(folder.path, words);
    REQUIRE_MESSAGE(run.exit_code == 0, run.err);
    return text_of(folder / "s.png");
  };
  const std::string image = rendered({});
  CHECK(rendered({"--cache", "kept/meshes"}) == image);
  CHECK(std::distance(std::filesystem::directory_iterator(folder / "kept/meshes"), {}) == 1);
  CHECK(rendered({"--cache", "kept/meshes"}) == image);
  const Finished run = run_program(folder.path, {"render", "s.json", "--cache", "s.json"});
  CHECK(run.exit_code == 4);
  CHECK(run.err == "refraster: s.json: cannot write: it is no folder, and none can be made there\n");
}
