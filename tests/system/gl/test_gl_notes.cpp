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

TEST_CASE("with --shadow map an exact shadow is drawn and judged as a map, and a note says so") {
  const TemporaryFolder folder;
  const std::string list = "\"direction_lights\": [{";
  save_text(folder / "s.json", ball_with(list, list + R"("shadow": "exact", )"));
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"gl", "s.json", "--size", "40x30", "--shadow", "map:64"},
                                             {"verify", "s.json", "--gl", "--size", "40x30", "--shadow", "map"}}) {
    const Finished run = run_program(folder.path, words);
    CHECK_MESSAGE(run.exit_code == 0, run.err);
    CHECK_MESSAGE((run.out + run.err).find("1 light has another than the file says: map") != std::string::npos,
                  (run.out + run.err));
  }
}

TEST_CASE("a scene with an exact shadow is drawn by render alone, and gl and verify --gl say so in a line") {
  const TemporaryFolder folder;
  const std::string list = "\"direction_lights\": [{";
  save_text(folder / "s.json", ball_with(list, list + R"("shadow": "exact", )"));
  const std::string line = "s.json: /scene/direction_lights/0/shadow: found \"exact\", which OpenGL does not cast, "
                           "expected \"none\" or a map for OpenGL, as with --shadow map; refraster render and explain "
                           "cast it\n";
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"gl", "s.json", "--size", "40x30"}, {"verify", "s.json", "--gl", "--size", "40x30"}}) {
    const Finished run = run_program(folder.path, words);
    CHECK(run.exit_code == 3);
    CHECK_MESSAGE(run.err.find(line) != std::string::npos, run.err);
    CHECK(run.out.empty());
  }
  CHECK(run_program(folder.path, {"render", "s.json", "--size", "40x30", "-o", "s.png"}).exit_code == 0);
  const Finished verified = run_program(folder.path, {"verify", "s.json", "s.png"});
  CHECK(verified.exit_code == 0);
  CHECK_MESSAGE((verified.out + verified.err).find("a light that has one may reach a surface or not") !=
                    std::string::npos,
                verified.out);
}
