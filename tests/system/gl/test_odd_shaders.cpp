// Every program that compiles draws an image that depends on nothing but scene and shaders, and what it asks for in
// vain is said.

#include <refraster/files.h>

#include "tests/support/program/program.h"
#include "tests/system/gl/odd_shaders.h"

#include <doctest/doctest.h>

#include <regex>
#include <sstream>

using namespace refraster;

namespace {

constexpr int width = 48, height = 32;

void save_scene(const TemporaryFolder& folder, const OddShader& odd) {
  std::string shaders;
  const auto add = [&](const std::string& text, const std::string& file, const std::string& key) {
    if (text.empty()) return;
    save_text(folder / file, text);
    shaders += "\"" + key + "\": \"" + file + "\", ";
  };
  add(odd.vertex, "vs.glsl", "vertex_shader_file_path");
  add(odd.fragment, "fs.glsl", "fragment_shader_file_path");
  save_text(folder / "scene.json", R"({"scene": {
  "camera": {"position": "0 0 3"}, "background": "0.25 0.5 0.75", "point_lights": [],
  "direction_lights": [{"direction": "0 0 -1", "radiance": "1 1 1"}],
  "objects": [{"mesh": {"sphere": {"segments": 24, "rings": 12}}, "name": "ball", "position": "0 0 0",
    "rotate_x": 0, "rotate_y": 0, "rotate_z": 0, "scale": "1 1 1", "fragment_function": "phong", )" +
                                       shaders + R"("material": {"ka": "0 0 0", "kd": "1 1 1", "ks": "0 0 0",
    "glossiness": 1}}]}})");
}

Finished drawn(const TemporaryFolder& folder, const std::string& renderer, const std::string& name) {
  return run_program(folder.path, {"gl", "scene.json", "-o", name + ".png", "--float", name + ".pfm", "--size",
                                   std::to_string(width) + "x" + std::to_string(height), "--renderer", renderer});
}

std::vector<std::string> warnings_of(const Finished& run) {
  std::vector<std::string> found;
  std::istringstream lines(run.err);
  const std::string begin = "warning: ";
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(begin)) found.push_back(line.substr(begin.size()));
  // How many pixels a ball has, and which is the first, is asked elsewhere.
  for (std::string& line : found)
    if (line.find("pixels are") != std::string::npos || line.find("with ours") != std::string::npos)
      line = std::regex_replace(line, std::regex(R"(\b(?!8 bits)\d+)"), "N");
  return found;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

} // namespace

TEST_CASE("of each odd shader what is said, what is seen and the exit code are as they should be") {
  for (const OddShader& odd : odd_shaders()) {
    INFO(odd.name);
    const TemporaryFolder folder;
    save_scene(folder, odd);
    const Finished run = drawn(folder, "llvmpipe", "first");
    CHECK_MESSAGE(run.exit_code == odd.exit_code, run.err);
    CHECK(joined(warnings_of(run)) == joined(odd.warnings));
    CHECK_MESSAGE(run.err.find(odd.error) != std::string::npos, run.err);
    if (run.exit_code != 0) continue;
    const Image<float> image = read_image(folder / "first.pfm").values;
    const float* const seen = image.at(width / 2, height / 2);
    if (odd.colour) {
      CHECK(std::array{seen[0], seen[1], seen[2]} == *odd.colour);
      continue;
    }
    // What a driver leaves undefined may differ between runs; nothing here does.
    REQUIRE(drawn(folder, "llvmpipe", "second").exit_code == 0);
    CHECK(text_of(folder / "first.png") == text_of(folder / "second.png"));
    CHECK(text_of(folder / "first.pfm") == text_of(folder / "second.pfm"));
  }
}

TEST_SUITE_BEGIN("slow");

TEST_CASE("through softpipe each odd shader that compiles is drawn alike, and no error of OpenGL ends the program") {
  int drawn_count = 0;
  for (const OddShader& odd : odd_shaders()) {
    INFO(odd.name);
    const TemporaryFolder folder;
    save_scene(folder, odd);
    const Finished run = drawn(folder, "softpipe", "image");
    CHECK_MESSAGE((run.exit_code == 0 || run.exit_code == 3), run.err);
    if (run.exit_code != 0) continue;
    ++drawn_count;
    CHECK(joined(warnings_of(run)) == joined(odd.warnings));
    const Image<float> image = read_image(folder / "image.pfm").values;
    const float* const seen = image.at(width / 2, height / 2);
    if (odd.colour) CHECK(std::array{seen[0], seen[1], seen[2]} == *odd.colour);
  }
  CHECK(drawn_count > 60); // all that need no more than GLSL 3.30
}

TEST_SUITE_END();
