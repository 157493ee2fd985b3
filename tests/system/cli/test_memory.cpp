// --max-memory: either the run ends as it should, or one line says what did not fit; and never is more taken.

#include "app/sanitizer.h"
#include "io/file/limits.h"
#include "tests/support/files/png_bytes.h"
#include "tests/support/program/program.h"
#include "tests/support/program/scenes.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace refraster;

namespace {

using Words = std::vector<std::string>;

constexpr std::uint64_t mebi = 1 << 20;

/// A sphere of 2 n (n - 1) triangles before a plane.
std::string big_scene(int n) {
  std::string text = ball_scene;
  const std::string small = R"("segments": 24, "rings": 12)";
  return text.replace(text.find(small), small.size(),
                      "\"segments\": " + std::to_string(n) + ", \"rings\": " + std::to_string(n));
}

/// How often a command ended well and how often it did not fit, over rising limits.
struct Outcomes {
  int done = 0, refused = 0;
};

Outcomes with_limits(const TemporaryFolder& folder, const Words& words, std::uint64_t most, std::uint64_t step) {
  Outcomes outcomes;
  for (std::uint64_t megabytes = 64; megabytes <= most; megabytes += step) {
    Words limited = words;
    limited.insert(limited.end(), {"--max-memory", std::to_string(megabytes) + "M"});
    const Finished run = run_program(folder.path, limited);
    INFO(words[0] << " with " << megabytes << "M: " << run.err);
    CHECK((run.exit_code == 0 || run.exit_code == 3));
    CHECK(run.peak_bytes <= megabytes * mebi);
    if (run.exit_code == 0) {
      ++outcomes.done;
      CHECK(run.err.empty());
      continue;
    }
    ++outcomes.refused;
    CHECK(run.err.starts_with("refraster: "));
    CHECK(run.err.ends_with("; --max-memory allows no more\n"));
    CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
    CHECK(run.out.empty());
  }
  return outcomes;
}

} // namespace

TEST_CASE("--max-memory takes sizes of at least 64M, and nothing else") {
  const TemporaryFolder folder;
  save_text(folder / "ball.json", ball_scene);
  for (const char* const size : {"64M", "67108864", "65536K", "2G", "1T"})
    CHECK(run_program(folder.path, {"render", "ball.json", "--size", "8x8", "--max-memory", size}).exit_code == 0);
  for (const char* const size : {"63M", "0", "", "M", "-1G", "1.5G", "64m", "64MB", "99999999999T", "2 G"}) {
    const Finished run = run_program(folder.path, {"render", "ball.json", "--max-memory", size});
    INFO(size);
    CHECK(run.exit_code == 2);
    CHECK(run.err.starts_with("refraster: --max-memory: found \""));
  }
}

TEST_CASE("what is asked for before it is made is named, and nothing is taken for it" *
          doctest::skip(built_with_sanitizer)) {
  const TemporaryFolder folder;
  save_text(folder / "ball.json", ball_scene);
  save_text(folder / "big.json", big_scene(2000));
  const auto refused = [&](const Words& words, const std::string& what) {
    Words limited = words;
    limited.insert(limited.end(), {"--max-memory", "64M"});
    const Finished run = run_program(folder.path, limited);
    INFO(run.err);
    CHECK(run.exit_code == 3);
    CHECK(run.err.starts_with("refraster: needs "));
    CHECK(run.err.find(" of memory for " + what + ", and of 64M only ") != std::string::npos);
    CHECK(run.peak_bytes < 64 * mebi);
  };
  refused({"render", "big.json"}, "7996000 triangles of a sphere");
  refused({"render", "ball.json", "--size", "8000x8000"}, "the image");
  refused({"mesh", "plane", "--segments", "4096"}, "33554432 triangles");
  test::write_files(folder.path, {{"i.pfm", "PF\n3000 3000\n-1\n", 16 + 3000 * 3000 * 12}});
  refused({"compare", "i.pfm", "i.pfm"}, "i.pfm");
}

TEST_SUITE_BEGIN("slow");

TEST_CASE("with any limit a run ends well or says that it does not fit, and never takes more" *
          doctest::skip(built_with_sanitizer)) {
  const TemporaryFolder folder;
  save_text(folder / "ball.json", ball_scene);
  save_text(folder / "big.json", big_scene(900));
  for (const char* const image : {"i.png", "i.exr", "i.pfm", "i.hdr"}) {
    const Words words = {"render", "big.json", "-o", image, "--size", "1500x1000", "--aov", "depth,normal"};
    const Outcomes found = with_limits(folder, words, 448, 80);
    CHECK(found.done > 0);
    CHECK(found.refused > 0);
  }
  const Words compare = {"compare", "i.png", "i.png", "--diff", "d.png", "--flip"};
  CHECK(with_limits(folder, compare, 320, 64).done > 0);
  CHECK(with_limits(folder, {"mesh", "sphere", "--segments", "900", "--rings", "900"}, 320, 64).done > 0);
  CHECK(with_limits(folder, {"brdf", "synth", "lambert"}, 320, 64).done > 0);
  CHECK(with_limits(folder, {"brdf", "info", "lambert.binary"}, 320, 64).done > 0);
  const Words bench = {"bench", "ball.json", "--size", "640x480", "--frames", "1", "--seconds", "0", "--gl", "none"};
  CHECK(with_limits(folder, bench, 320, 64).done > 0);
}

TEST_CASE("a hostile file takes no more memory than the documented multiple of its size" *
          doctest::skip(built_with_sanitizer)) {
  const TemporaryFolder folder;
  const std::uint64_t idle = run_program(folder.path, {"list", "precisions"}).peak_bytes;
  const auto check = [&](const std::string& name, const std::string& file, const std::string& text, std::uint64_t times,
                         std::uint64_t more = 0) {
    save_text(folder / file, text);
    const Finished run = run_program(folder.path, {"render", "s.json", "--size", "8x8", "-o", "i.png"});
    INFO(name << ": " << run.err.substr(0, 200));
    CHECK((run.exit_code == 0 || run.exit_code == 3));
    const double taken = static_cast<double>(run.peak_bytes - std::min(run.peak_bytes, idle));
    MESSAGE(name << ": " << taken / static_cast<double>(text.size()) << " times its size");
    CHECK(run.peak_bytes <= idle + 4 * mebi + times * text.size() + more);
  };
  const auto repeated = [](const std::string& part, std::size_t bytes) {
    std::string text;
    while (text.size() < bytes) text += part;
    return text;
  };
  constexpr std::size_t size = 9 << 19; // past a power of two, where lists have just grown to twice their size
  for (const auto& [name, part] : {std::pair{"a list of numbers", "0,"}, std::pair{"a list of lists", "[],"},
                                   std::pair{"a list of objects", "{},"}, std::pair{"a list of texts", "\"\","}})
    check(name, "s.json", "[" + repeated(part, size) + "0]", 75);
  check("a text of commas", "s.json", "[\"" + repeated(",", size) + "\"]", 75);
  const std::string camera = R"({"position": [0, 0, 3], "target": [0, 0, 0], "fov_y": 45})";
  std::string objects = "{}";
  for (std::uint64_t i = 1; i < limit::objects.value; ++i) objects += ",{}";
  check("empty objects", "s.json",
        R"({"scene": {"camera": )" + camera + R"(, "point_lights": [], "direction_lights": [], "objects": [)" +
            objects + "]}}",
        75, 4096 * limit::objects.value);
  check("unknown keys", "s.json", "{" + repeated("\"\":0,", size) + "\"\":0}", 75);

  save_text(folder / "s.json", ball_from_file());
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
  std::string polygon = "f";
  for (int i = 0; i < 1024; ++i) polygon += " 1 2 4 3";
  for (const auto& [name, part] :
       {std::pair{"vertices", std::string("v 0 0 0\n")}, std::pair{"texture coordinates", std::string("vt 0\n")},
        std::pair{"triangles", std::string("f 1 2 3\n")}, std::pair{"quads", std::string("f 1 2 4 3\n")},
        std::pair{"flat quads", std::string("s off\nf 1 2 4 3\n")}, std::pair{"polygons", polygon + "\n"},
        std::pair{"indices that are not there", std::string("f 9 9 9\n")}, std::pair{"words", std::string("f x\n")},
        std::pair{"separate triangles", corners + "f -4 -3 -2\n"}})
    check(name, "m.obj", corners + repeated(part, size) + "f 1 2 3\n", 100);
  check("flat polygons", "m.obj", corners + "s off\n" + repeated(polygon + "\n", size), 100);
  check("flat triangles", "m.obj", corners + "s off\n" + repeated("f 1 2 3\n", size), 100);
}

TEST_SUITE_END();
