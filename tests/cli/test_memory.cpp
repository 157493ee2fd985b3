// --max-memory: either the run ends as it should, or one line says what did not fit; and never is more taken.

#include "program.h"
#include "scenes.h"
#include "tests/io/png_bytes.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace refraster;

namespace {

using Words = std::vector<std::string>;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitizer = true; // takes memory as it likes
#else
constexpr bool sanitizer = false;
#endif

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
    CHECK(run.err.starts_with("--max-memory: found \""));
  }
}

TEST_CASE("what is asked for before it is made is named, and nothing is taken for it" * doctest::skip(sanitizer)) {
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
          doctest::skip(sanitizer)) {
  const TemporaryFolder folder;
  save_text(folder / "ball.json", ball_scene);
  save_text(folder / "big.json", big_scene(900));
  for (const char* const image : {"i.png", "i.exr", "i.pfm", "i.hdr"}) {
    const Words words = {"render", "big.json", "-o", image, "--size", "1500x1000", "--aov", "depth,normal"};
    const Outcomes found = with_limits(folder, words, 448, 48);
    CHECK(found.done > 0);
    CHECK(found.refused > 0);
  }
  const Words compare = {"compare", "i.png", "i.png", "--diff", "d.png", "--flip"};
  CHECK(with_limits(folder, compare, 320, 64).done > 0);
  CHECK(with_limits(folder, {"mesh", "sphere", "--segments", "900", "--rings", "900"}, 320, 64).done > 0);
  CHECK(with_limits(folder, {"merl", "synth", "lambert"}, 320, 64).done > 0);
  CHECK(with_limits(folder, {"merl", "info", "lambert.binary"}, 320, 64).done > 0);
  const Words bench = {"bench", "ball.json", "--size", "640x480", "--frames", "1", "--seconds", "0", "--gl", "none"};
  CHECK(with_limits(folder, bench, 320, 64).done > 0);
}

TEST_SUITE_END();
