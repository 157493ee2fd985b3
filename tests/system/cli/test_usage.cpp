// Help, version, and what is said to wrong arguments.

#include "tests/support/program/program.h"
#include "tests/support/program/scenes.h"

#include <doctest/doctest.h>

using namespace refraster;

namespace {

using Words = std::vector<std::string>;

const std::vector<Words> every_level = {
    {},
    {"render"},
    {"compare"},
    {"bench"},
    {"mesh"},
    {"mesh", "sphere"},
    {"mesh", "cube"},
    {"mesh", "plane"},
    {"mesh", "torus"},
    {"merl"},
    {"merl", "info"},
    {"merl", "synth"},
    {"merl", "synth", "lambert"},
    {"merl", "synth", "ggx-conductor"},
    {"merl", "synth", "ggx-dielectric"},
    {"merl", "synth", "brass-like"},
    {"list"},
    {"list", "fragment-functions"},
    {"list", "precisions"},
    {"list", "limits"},
    {"list", "scene-format"},
};

std::string joined(const Words& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

Words with(Words words, const std::string& last) {
  words.push_back(last);
  return words;
}

} // namespace

TEST_CASE("--help is there at every level, on standard output, and succeeds") {
  const TemporaryFolder folder;
  for (const Words& level : every_level) {
    const Finished run = run_program(folder.path, with(level, "--help"));
    INFO(joined(level));
    CHECK(run.exit_code == 0);
    CHECK(run.err.empty());
    CHECK(run.out.find("--help") != std::string::npos);
    CHECK(run.out.find("--version") != std::string::npos);
  }
}

TEST_CASE("--version is there at every level, and says the same") {
  const TemporaryFolder folder;
  for (const Words& level : every_level) {
    const Finished run = run_program(folder.path, with(level, "--version"));
    INFO(joined(level));
    CHECK(run.exit_code == 0);
    CHECK(run.out.starts_with("refraster "));
    CHECK(run.out.find('\n') == run.out.size() - 1);
  }
}

TEST_CASE("help prints the defaults") {
  const TemporaryFolder folder;
  const std::string help = run_program(folder.path, {"render", "--help"}).out;
  for (const std::string expected : {"=1280x720", "=double", "=64", "=0", "=1"})
    CHECK_MESSAGE(help.find(expected) != std::string::npos, expected);
}

TEST_CASE("every wrong argument is answered with exit code 2, one line and a hint, and nothing is written") {
  const TemporaryFolder folder;
  save_text(folder / "ball.json", ball_scene);
  const std::vector<Words> wrong = {
      {},
      {"paint"},
      {"--quiet"},
      {"render"},
      {"render", "ball.json", "more"},
      {"render", "ball.json", "--colour"},
      {"render", "ball.json", "--size", "640"},
      {"render", "ball.json", "--size", "640x"},
      {"render", "ball.json", "--size", "0x10"},
      {"render", "ball.json", "--size", "16385x1"},
      {"render", "ball.json", "--size", "640x480x3"},
      {"render", "ball.json", "--size", "6 4x10"},
      {"render", "ball.json", "--size", "99999999999x1"},
      {"render", "ball.json", "--size", "-4x4"},
      {"render", "ball.json", "--crop", "0,0,0,5"},
      {"render", "ball.json", "--crop", "1,2,3"},
      {"render", "ball.json", "--crop", "1270,0,11,5"},
      {"render", "ball.json", "--crop", "0,16384,1,16384"},
      {"render", "ball.json", "--precision", "half"},
      {"render", "ball.json", "--precision", ""},
      {"render", "ball.json", "--samples", "3"},
      {"render", "ball.json", "--threads", "-1"},
      {"render", "ball.json", "--threads", "two"},
      {"render", "ball.json", "--threads", "0x4"},
      {"render", "ball.json", "--report", "ball.json"},
      {"render", "ball.json", "-o", "same.png", "--report", "./same.png"},
      {"render", "ball.json", "-o", "same.exr", "--aov", "depth", "--report", "same.depth.exr"},
      {"render", "ball.json", "--tile-size", "48"},
      {"render", "ball.json", "--aov", "depth,colour"},
      {"render", "ball.json", "--aov", "depth,depth"},
      {"render", "ball.json", "--aov", ""},
      {"render", "ball.json", "-o", "ball.jpg"},
      {"render", "ball.json", "-o", "ball"},
      {"render", "ball.json", "-o", "ball.json"},
      {"render", "ball.json", "-o", "ball.exr", "--srgb"},
      {"compare", "a.png"},
      {"compare", "a.png", "b.png", "--max-abs", "-1"},
      {"compare", "a.png", "b.png", "--max-abs", "x"},
      {"compare", "a.png", "b.png", "--max-abs", "nan"},
      {"compare", "a.png", "b.png", "--max-abs", "inf"},
      {"compare", "a.png", "b.png", "--max-rms", "-0.1"},
      {"compare", "a.png", "b.png", "--max-count", "-1"},
      {"compare", "a.png", "b.png", "--max-count", "1.5"},
      {"compare", "a.png", "b.png", "--unit", "level"},
      {"compare", "a.png", "b.png", "--alpha", "drop"},
      {"compare", "a.png", "b.png", "--alpha", "over:1,1"},
      {"compare", "a.png", "b.png", "--alpha", "over:1,1,1,1"},
      {"compare", "a.png", "b.png", "--alpha", "over:1,-1,1"},
      {"compare", "a.png", "b.png", "--premultiplied", "maybe"},
      {"compare", "a.png", "b.png", "--diff", "d.png", "--heat-max", "0"},
      {"compare", "a.png", "b.png", "--heat-max", "9"},
      {"compare", "a.png", "b.png", "--diff", "d.exr"},
      {"compare", "a.png", "b.png", "--diff", "a.png"},
      {"compare", "a.png", "b.png", "--diff", "d.png", "--json", "d.png"},
      {"gl", "ball.json", "--frames", "1.5"},
      {"gl", "ball.json", "--float", "same.exr", "--depth", "same.exr"},
      {"bench", "ball.json", "--json", "-", "--html", "-"},
      {"bench", "ball.json", "--precisions", "half"},
      {"bench", "ball.json", "--precisions", "float,float"},
      {"bench", "ball.json", "--precisions", ""},
      {"bench", "ball.json", "--size", "64x36,64x36"},
      {"bench", "ball.json", "--size", "64x36,"},
      {"bench", "ball.json", "--threads", "0"},
      {"bench", "ball.json", "--threads", "1,1"},
      {"bench", "ball.json", "--threads", "1,1025"},
      {"bench", "ball.json", "--threads", "1,"},
      {"bench", "ball.json", "--frames", "0"},
      {"bench", "ball.json", "--seconds", "-1"},
      {"bench", "ball.json", "--samples", "3"},
      {"bench", "ball.json", "--gl", "voodoo"},
      {"bench", "--scaling", "vertices"},
      {"bench", "--scaling", "pixels:many"},
      {"bench", "--scaling", "pixels:0"},
      {"bench", "--scaling", ""},
      {"mesh"},
      {"mesh", "cone"},
      {"mesh", "sphere", "--segments", "2"},
      {"mesh", "sphere", "--rings", "1"},
      {"mesh", "sphere", "--rings", "1.5"},
      {"mesh", "torus", "--tube-radius", "0"},
      {"mesh", "torus", "--tube-radius", "nan"},
      {"merl"},
      {"merl", "info"},
      {"merl", "synth"},
      {"merl", "synth", "gold"},
      {"merl", "synth", "lambert", "--albedo", "1.5"},
      {"merl", "synth", "lambert", "--albedo", "0.1,0.2"},
      {"merl", "synth", "ggx-conductor", "--alpha", "0"},
      {"merl", "synth", "ggx-dielectric", "--ior", "1"},
      {"list"},
      {"list", "colours"},
  };
  for (const Words& words : wrong) {
    const Finished run = run_program(folder.path, words);
    INFO(joined(words) << "\n" << run.err);
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    CHECK(run.err.find("--help") != std::string::npos);
  }
  CHECK(files_in(folder) == Words{"ball.json"});
}

TEST_CASE("a leading zero is no octal number") {
  const TemporaryFolder folder;
  save_text(folder / "ball.json", ball_scene);
  const Finished run = run_program(folder.path, {"render", "ball.json", "--threads", "010", "--report", "-"});
  CHECK(run.out.find("\"threads\": 10,") != std::string::npos);
}

TEST_CASE("of a scene without a name it is the scene that is wrong") {
  const TemporaryFolder folder;
  for (const char* const scene : {"", ".", "./"}) {
    const Finished run = run_program(folder.path, {"render", scene});
    INFO(run.err);
    CHECK(run.exit_code == 3);
    CHECK(run.err.find("a scene file") != std::string::npos);
  }
}

TEST_CASE("what is wrong with a later scene is reported before the first is measured") {
  const TemporaryFolder folder;
  save_text(folder / "ball.json", ball_scene);
  const Finished run = run_program(folder.path, {"bench", "ball.json", "none.json", "--seconds", "3600"});
  CHECK(run.exit_code == 3);
  CHECK(run.err.find("none.json") != std::string::npos);
}

TEST_CASE("what there is to choose from is listed") {
  const TemporaryFolder folder;
  const std::string functions = run_program(folder.path, {"list", "fragment-functions"}).out;
  for (const std::string name : {"phong", "blinn_phong", "merl", "glossiness", "merl_lookup"})
    CHECK_MESSAGE(functions.find(name) != std::string::npos, name);
  const std::string precisions = run_program(folder.path, {"list", "precisions"}).out;
  CHECK(precisions.starts_with("double"));
  CHECK(precisions.find("\nfloat") != std::string::npos);
  CHECK(run_program(folder.path, {"list", "scene-format"}).out.find("fov_y") != std::string::npos);
}
