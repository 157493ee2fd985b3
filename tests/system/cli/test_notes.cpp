// What a run says beside its image: notes, on standard error and in the report.

#include "tests/support/program/program.h"
#include "tests/support/program/scenes.h"

#include <doctest/doctest.h>

using namespace refraster;

namespace {

using Words = std::vector<std::string>;

/// The ball scene, all of it beyond the far plane.
std::string far_scene() {
  const std::string from = "\"fov_y\": 40";
  std::string text = ball_scene;
  REQUIRE(text.find(from) != std::string::npos);
  return text.replace(text.find(from), from.size(), from + ", \"far\": 0.5");
}

const std::string far_note =
    "the image shows background only: both objects lie beyond the far plane, 0.5; the nearest is ";

} // namespace

TEST_CASE("an image that shows something is said nothing of") {
  const TemporaryFolder folder;
  save_text(folder / "ball.json", ball_scene);
  const Finished run = run_program(folder.path, {"render", "ball.json", "--size", "40x30", "--report", "-"});
  CHECK(run.err.empty());
  CHECK_MESSAGE(run.out.find("\"notes\": []") != std::string::npos, run.out);
}

TEST_CASE("an image without a surface is explained, on standard error and in the report; not with -q, there") {
  const TemporaryFolder folder;
  save_text(folder / "far.json", far_scene());
  const Finished run = run_program(folder.path, {"render", "far.json", "--size", "40x30", "--report", "report.json"});
  CHECK(run.exit_code == 0);
  CHECK_MESSAGE(run.err.starts_with("note: " + far_note), run.err);
  CHECK(text_of(folder / "report.json").find("\"notes\": [\"" + far_note) != std::string::npos);
  const Finished quiet =
      run_program(folder.path, {"render", "far.json", "--size", "40x30", "-q", "--report", "report.json"});
  CHECK(quiet.err.empty());
  CHECK(text_of(folder / "report.json").find("\"notes\": [\"" + far_note) != std::string::npos);
  // It is no remark on a file.
  CHECK(run_program(folder.path, {"render", "far.json", "--size", "40x30", "--strict"}).exit_code == 0);
}

TEST_CASE("the lecture's scene says why it is dark, and that its table is not read") {
  const TemporaryFolder folder;
  const std::string scene = std::string(REFRASTER_SOURCE_DIR) + "/scenes/lecture/config.json";
  const Finished run = run_program(folder.path, {"render", scene, "--size", "64x36"});
  CHECK(run.exit_code == 0);
  CHECK_MESSAGE(run.err.find(": found brdf_file_path \"resource/brdfs/nylon.binary\", not read: the fragment function "
                             "phong uses no measured table\n") != std::string::npos,
                run.err);
  CHECK_MESSAGE(
      run.err.find("note: the image is nearly black, no value above 16 of 255: little light reaches what is "
                   "seen, 0.028 at most (radiance times attenuation times n.l); 1 of 2 lights is behind it\n") !=
          std::string::npos,
      run.err);
}

TEST_CASE("the README's first scene needs no other file, shows something everywhere, and has no note") {
  const TemporaryFolder folder;
  save_text(folder / "hello.json", text_of(std::string(REFRASTER_SOURCE_DIR) + "/scenes/hello.json"));
  const Finished run = run_program(
      folder.path, {"render", "hello.json", "--size", "64x36", "--strict", "-o", "hello.png", "--report", "r.json"});
  CHECK(run.exit_code == 0);
  CHECK(run.err.empty());
  CHECK(text_of(folder / "r.json").find("\"shaded\": 2304,") != std::string::npos); // 64 * 36
}

TEST_CASE("an OBJ file of another name: render, gl and bench say how to get a scene, and it can be copied") {
  const TemporaryFolder folder;
  save_text(folder / "model.txt", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n");
  std::string advice;
  for (const char* const command : {"render", "gl", "bench"}) {
    const Finished run = run_program(folder.path, {command, "model.txt"});
    CHECK(run.exit_code == 3);
    CHECK(run.out.empty());
    CHECK_MESSAGE(run.err.starts_with("refraster: model.txt: found an OBJ file, expected a scene file\n"), run.err);
    CHECK((advice.empty() || advice == run.err));
    advice = run.err;
  }
  const std::size_t begin = advice.find("\n{"), end = advice.find("\n}}\n");
  REQUIRE(end != std::string::npos);
  CHECK(advice.find("save it as model.json") != std::string::npos);
  save_text(folder / "model.json", advice.substr(begin, end + 4 - begin));
  const Finished run = run_program(folder.path, {"render", "model.json", "--size", "64x48", "--strict"});
  CHECK(run.exit_code == 0);
  CHECK(run.err.empty());
}
