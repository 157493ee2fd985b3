// What refraster gl says of an image that shows nothing, where the reason lies in the scene.

#include "tests/support/program/program.h"
#include "tests/support/program/scenes.h"

#include <doctest/doctest.h>

using namespace refraster;

namespace {

std::string ball_with(const std::string& from, const std::string& to) {
  std::string scene = ball_scene;
  REQUIRE(scene.find(from) != std::string::npos);
  return scene.replace(scene.find(from), from.size(), to);
}

} // namespace

TEST_CASE("OpenGL's image without a surface is explained, in 8 bits and in float; not with -q") {
  const TemporaryFolder folder;
  save_text(folder / "far.json", ball_with("\"fov_y\": 40", "\"far\": 0.5"));
  const std::string note = "note: the image shows background only: both objects lie beyond the far plane, 0.5; ";
  for (const char* const output : {"-o", "--float"}) {
    const std::string file = output == std::string("-o") ? "a.png" : "a.exr";
    const Finished run = run_program(folder.path, {"gl", "far.json", "--size", "40x30", output, file});
    CHECK(run.exit_code == 0);
    CHECK_MESSAGE(run.err.find(note) != std::string::npos, run.err);
  }
  CHECK(run_program(folder.path, {"gl", "far.json", "--size", "40x30", "-q"}).err.empty());
}

TEST_CASE("OpenGL's image that shows something is not explained") {
  const TemporaryFolder folder;
  save_text(folder / "ball.json", ball_scene);
  const Finished run = run_program(folder.path, {"gl", "ball.json", "--size", "40x30"});
  CHECK(run.exit_code == 0);
  CHECK_MESSAGE(run.err.find("note:") == std::string::npos, run.err);
}
