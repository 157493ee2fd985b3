// Help, version, and what is said to wrong arguments.

#include "app/options/wrap.h"
#include "tests/support/program/program.h"
#include "tests/support/program/scenes.h"
#include "tests/support/program/terminal.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <sstream>
#include <sys/ioctl.h>
#include <unistd.h>

using namespace refraster;

namespace {

using Words = std::vector<std::string>;

const std::vector<Words> every_level = {
    {},
    {"render"},
    {"turntable"},
    {"assemble"},
    {"compare"},
    {"bench"},
    {"suite"},
    {"suite", "run"},
    {"suite", "update"},
    {"suite", "merge"},
    {"mesh"},
    {"mesh", "sphere"},
    {"mesh", "cube"},
    {"mesh", "plane"},
    {"mesh", "torus"},
    {"mesh", "knot"},
    {"brdf"},
    {"brdf", "info"},
    {"brdf", "eval"},
    {"brdf", "compare"},
    {"brdf", "fit"},
    {"brdf", "plot"},
    {"brdf", "import"},
    {"brdf", "synth"},
    {"brdf", "synth", "lambert"},
    {"brdf", "synth", "ggx-conductor"},
    {"brdf", "synth", "ggx-dielectric"},
    {"brdf", "synth", "brass-like"},
    {"list"},
    {"list", "fragment-functions"},
    {"list", "precisions"},
    {"list", "devices"},
    {"list", "device-values"},
    {"list", "limits"},
    {"list", "scene-format"},
    {"list", "completions"},
    {"list", "man-page"},
};

std::string joined(const Words& words, const char* separator = " ") {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
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
  for (const std::string expected : {"or 1280x720)", "(default double)", "(default 64)", "(default 0)", "or 1)"})
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
      {"render", "ball.json", "--shard", "0/2"},
      {"render", "ball.json", "--shard", "3/2"},
      {"render", "ball.json", "--shard", "2"},
      {"turntable", "ball.json", "-o", "##.png", "--shard", "0/2"},
      {"turntable", "ball.json", "-o", "##.png", "--shard", "1/2", "--report", "r.json"},
      {"turntable", "ball.json", "-o", "x.mp4", "--shard", "1/2"},
      {"assemble"},
      {"assemble", "part"},
      {"assemble", "-o", "x.png"},
      {"assemble", "part", "-o", "x.mp4", "--rate", "0"},
      {"render", "ball.json", "--tile-size", "48"},
      {"render", "ball.json", "--aov", "depth,colour"},
      {"render", "ball.json", "--aov", "depth,depth"},
      {"render", "ball.json", "--aov", ""},
      {"render", "ball.json", "-o", "ball.gif"},
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
      {"brdf"},
      {"brdf", "info"},
      {"brdf", "synth"},
      {"brdf", "synth", "gold"},
      {"brdf", "synth", "lambert", "--albedo", "1.5"},
      {"brdf", "synth", "lambert", "--albedo", "0.1,0.2"},
      {"brdf", "synth", "ggx-conductor", "--alpha", "0"},
      {"brdf", "synth", "ggx-dielectric", "--ior", "1"},
      {"list"},
      {"list", "colours"},
      {"list", "completions"},
      {"list", "completions", "tcsh"},
      {"list", "man-page", "paint"},
      {"list", "man-page", "render", "paint"},
      {"render", "ball.json", "--quiet=very"},
      {"render", "ball.json", "--threads", "1", "--threads", "2"},
      {"render", "ball.json", "--size"},
      {"render", "ball.json", "-qo"},
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

TEST_CASE("what is wrong is named, with what was meant and what there is") {
  const TemporaryFolder folder;
  save_text(folder / "ball.json", ball_scene);
  const auto said_of = [&](const Words& words) {
    const std::string err = run_program(folder.path, words).err;
    return err.substr(0, err.find('\n'));
  };
  CHECK(said_of({"rendr"}) ==
        "refraster: found \"rendr\", expected one of render, turntable, assemble, verify, explain, "
        "compare, gl, view, bench, suite, scene, mesh, brdf, list; did you mean render?");
  CHECK(said_of({"brdf", "sinth"}) == "refraster: brdf: found \"sinth\", expected one of info, synth, eval, compare, "
                                      "fit, plot, import; did you mean synth?");
  CHECK(said_of({"brdf"}) ==
        "refraster: brdf: found nothing, expected one of info, synth, eval, compare, fit, plot, import");
  CHECK(said_of({"render"}) ==
        "refraster: render: found nothing, expected SCENE (scene file or OBJ model; docs/scene-format.md)");
  CHECK(said_of({"compare", "a.png"}).starts_with("refraster: compare: found nothing, expected B ("));
  CHECK(said_of({"render", "ball.json", "more"}) ==
        "refraster: render: found \"more\", expected no argument but SCENE");
  CHECK(said_of({"render", "ball.json", "--size"}) == "refraster: --size: found nothing, expected WxH");
  const std::string unknown = said_of({"render", "ball.json", "4", "--sample", "4"});
  CHECK(unknown.starts_with("refraster: render: found \"--sample\", expected one of --"));
  CHECK(unknown.ends_with("; did you mean --samples?"));
  CHECK(said_of({"render", "ball.json", "-quiet"}).find("found \"-quiet\"") != std::string::npos);
  CHECK(
      said_of({"--quiet", "render", "ball.json"}) ==
      "refraster: found \"--quiet\", expected a command before it, "
      "one of render, turntable, assemble, verify, explain, compare, gl, view, bench, suite, scene, mesh, brdf, list");
  CHECK(said_of({"render", "ball.json", "--precision", "flaot"}) ==
        "refraster: --precision: found \"flaot\", expected one of double, float, fast, exact; did you mean float?");
  CHECK(said_of({"render", "ball.json", "--aov", "depth,norml"}) ==
        "refraster: --aov: found \"norml\", expected one of depth, normal, position, uv, albedo, triangle, object, "
        "distance, alpha, material; did you mean normal?");
  CHECK(said_of({"bench", "--precisions", "double,flot"}).ends_with("; did you mean float?"));
}

TEST_CASE("who writes blanks between values is told about commas") {
  const TemporaryFolder folder;
  save_text(folder / "ball.json", ball_scene);
  const auto hint_in = [&](const Words& words) {
    const std::string err = run_program(folder.path, words).err;
    const std::size_t hint = err.find("; commas stand between values: ");
    return hint == std::string::npos ? "" : err.substr(hint + 31, err.find('\n') - hint - 31);
  };
  CHECK(hint_in({"render", "ball.json", "--crop", "0", "0", "4", "4"}) == "--crop 0,0,4,4");
  CHECK(hint_in({"render", "--crop", "0 0 4 4", "ball.json"}) == "--crop 0,0,4,4");
  CHECK(hint_in({"render", "--crop=0, 0, 4, 4", "ball.json"}) == "--crop 0,0,4,4");
  CHECK(hint_in({"render", "--aov", "depth", "normal", "ball.json"}) == "--aov depth,normal");
  CHECK(hint_in({"brdf", "synth", "lambert", "--albedo", "0.1", "0.2", "0.3"}) == "--albedo 0.1,0.2,0.3");
  CHECK(hint_in({"render", "ball.json", "--crop", "0,0,0,4"}).empty());
  CHECK(hint_in({"render", "ball.json", "--aov", "depth,normal", "more"}).empty());
}

TEST_CASE("a command without the one that must follow prints its help to standard error") {
  const TemporaryFolder folder;
  for (const Words& level : {Words{}, Words{"mesh"}, Words{"brdf"}, Words{"brdf", "synth"}, Words{"list"}}) {
    const Finished bare = run_program(folder.path, level);
    INFO(joined(level));
    CHECK(bare.exit_code == 2);
    CHECK(bare.err.ends_with("\n\n" + run_program(folder.path, with(level, "--help")).out));
  }
}

TEST_CASE("--help and --version are answered wherever they stand, whatever else is wrong") {
  const TemporaryFolder folder;
  const std::string help = run_program(folder.path, {"render", "--help"}).out;
  for (const Words& words : {Words{"--help", "render"}, Words{"render", "-h"},
                             Words{"render", "--sample", "-h", "a", "b"}, Words{"render", "--size", "0", "--help"}}) {
    const Finished run = run_program(folder.path, words);
    INFO(joined(words));
    CHECK(run.exit_code == 0);
    CHECK(run.out == help);
  }
  CHECK(run_program(folder.path, {"--version", "render"}).out == run_program(folder.path, {"--version"}).out);
}

TEST_CASE("options are given in any form: behind '=', as one word with a short name, after --") {
  const TemporaryFolder folder;
  save_text(folder / "-b.json", empty_scene);
  CHECK(run_program(folder.path, {"render", "--size=8x8", "-qoa.png", "--", "-b.json"}).exit_code == 0);
  CHECK(files_in(folder) == Words{"-b.json", "a.png"});
}

TEST_CASE("on a terminal, help and messages are wrapped at its width") {
  if (std::getenv("COLUMNS") != nullptr) return; // which goes before the terminal's own
  const TemporaryFolder folder;
  for (const int columns : {50, 100}) {
    const Terminal terminal;
    const int device = open(terminal.path().c_str(), O_RDWR | O_NOCTTY);
    const winsize size{50, static_cast<unsigned short>(columns), 0, 0};
    REQUIRE(ioctl(device, TIOCSWINSZ, &size) == 0);
    CHECK(Running(folder.path, {"render", "--sample"}, terminal.path()).wait().exit_code == 2);
    CHECK(Running(folder.path, {}, terminal.path()).wait().exit_code == 2);
    std::istringstream lines(terminal.rest());
    int widest = 0;
    for (std::string line; std::getline(lines, line);) widest = std::max(widest, columns_of(line) - 1); // of "\r\n"
    close(device);
    INFO(columns);
    CHECK(widest <= columns);
    CHECK(widest > columns - 20); // no word is longer
  }
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

TEST_CASE("pages of the manual are written to a folder, a file for each command") {
  const TemporaryFolder folder;
  CHECK(run_program(folder.path, {"list", "man-page", "brdf", "--folder", "a/b"}).exit_code == 0);
  const Finished page = run_program(folder.path, {"list", "man-page", "brdf", "info"});
  CHECK(page.out.starts_with(".TH REFRASTER\\-BRDF\\-INFO 1 "));
  CHECK(text_of(folder / "a/b/refraster-brdf-info.1") == page.out);
  for (const Words& level : every_level) {
    if (level.empty() || level.front() != "brdf") continue;
    CHECK_MESSAGE(std::filesystem::exists(folder / ("a/b/refraster-" + joined(level, "-") + ".1")), joined(level));
  }
  const Finished nowhere = run_program(folder.path, {"list", "man-page", "--folder", "/proc/nothing"});
  CHECK(nowhere.exit_code == 4);
  CHECK(nowhere.err.find("/proc/nothing") != std::string::npos);
}

TEST_CASE("help says how to read the page of the manual, which is not installed beside a build") {
  const TemporaryFolder folder;
  CHECK(run_program(folder.path, {"brdf", "info", "--help"})
            .out.ends_with("Page of the manual: `refraster list man-page brdf info | man -l -`\n"));
  CHECK(
      run_program(folder.path, {"--help"}).out.ends_with("Page of the manual: `refraster list man-page | man -l -`\n"));
}
