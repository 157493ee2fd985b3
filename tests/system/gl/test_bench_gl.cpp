// OpenGL's frames between ours, in refraster bench.

#include "tests/support/program/program.h"
#include "tests/support/program/scenes.h"
#include "tests/support/text.h"

#include <doctest/doctest.h>

#include <cstdlib>

using namespace refraster;

namespace {

using Words = std::vector<std::string>;

struct BallFolder : TemporaryFolder {
  BallFolder() { save_text(*this / "ball.json", ball_scene); }

  Finished bench(Words more) const {
    Words words = {"bench", "ball.json", "--size", "80x45",         "--frames",     "2",         "--json",
                   "-",     "--seconds", "0",      "--no-marginal", "--no-command", "--no-error"};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(path, words);
  }
};

std::size_t count(const std::string& text, const std::string& words) {
  std::size_t found = 0;
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++found;
  return found;
}

} // namespace

TEST_CASE("bench draws with OpenGL too, for each number of threads, and tells the ratio for each of our results") {
  const BallFolder folder;
  for (const char* const renderer : {"llvmpipe", "softpipe"}) {
    const Finished run = folder.bench({"--threads", "1,2", "--gl", renderer});
    REQUIRE_MESSAGE(run.exit_code == 0, run.err);
    CHECK(count(run.out, "\"renderer\": \"" + std::string(renderer)) == 2);
    CHECK(count(run.out, "\"opengl_ratio\": {") == count(run.out, "\"precision\": "));
    CHECK(count(run.out, "\"of_cpu_medians\"") >= 2);
    CHECK(!holds(run.out, "without OpenGL beside")); // there may be notes on the load of the machine
  }
}

TEST_CASE("GLSL that does not compile ends a benchmark that asked for OpenGL, and is a note in another") {
  const BallFolder folder;
  std::string scene = ball_scene;
  const std::string phong = R"("fragment_function": "phong",)";
  scene.replace(scene.find(phong), phong.size(), phong + R"( "fragment_shader_file_path": "broken.glsl",)");
  save_text(folder / "ball.json", scene);
  save_text(folder / "broken.glsl", "#version 330 core\nvoid main() { colour; }\n");
  const Finished asked = folder.bench({"--gl", "llvmpipe"});
  CHECK(asked.exit_code == 5);
  CHECK_MESSAGE(holds(asked.err, "broken.glsl:2:"), asked.err);
  CHECK(asked.out.empty());
  const Finished by_default = folder.bench({});
  CHECK(by_default.exit_code == 0);
  CHECK_MESSAGE(holds(by_default.out, "without OpenGL beside: "), by_default.out);
}

TEST_CASE("several samples a pixel are measured without OpenGL") {
  const BallFolder folder;
  const Finished run = folder.bench({"--samples", "4"});
  CHECK(run.exit_code == 0);
  CHECK(holds(run.out, "OpenGL is left out"));
  CHECK(holds(run.out, "\"opengl\": []"));
}

TEST_CASE("without an EGL library a benchmark says so, and measures the rest") {
  const BallFolder folder;
  std::filesystem::create_directory(folder / "libraries");
  save_text(folder / "libraries/libEGL.so.1", "not a library");
  setenv("LD_LIBRARY_PATH", (folder / "libraries").c_str(), 1);
  const Finished run = folder.bench({}), asked = folder.bench({"--gl", "llvmpipe"});
  unsetenv("LD_LIBRARY_PATH");
  CHECK(run.exit_code == 0);
  CHECK_MESSAGE(holds(run.out, "no EGL library"), run.out);
  CHECK(asked.exit_code == 5);
}
