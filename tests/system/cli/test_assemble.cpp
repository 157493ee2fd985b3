// refraster render --shard, turntable --shard, assemble.

#include <refraster/files.h>

#include "tests/support/program/program.h"
#include "tests/support/program/scenes.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>

namespace refraster {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

Words operator+(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

struct Parts : TemporaryFolder {
  Parts() { save_text(*this / "s.json", ball_scene); }

  Finished run(const Words& words) const { return run_program(path, words); }
  /// The parts of `count`, by their names.
  Words render(const std::string& output, int count, const Words& options) const {
    Words names;
    for (int part = count; part >= 1; --part) { // any order
      const std::string shard = std::to_string(part) + "/" + std::to_string(count);
      const Finished done = run(Words{"render", "s.json", "-o", output, "--shard", shard} + options);
      REQUIRE_MESSAGE(done.exit_code == 0, done.err);
      names.push_back(output + ".part-" + std::to_string(part) + "-of-" + std::to_string(count));
      CHECK(done.out == names.back() + "\n");
    }
    return names;
  }
  Finished assemble(const Words& parts, const std::string& output) const {
    return run(Words{"assemble", "-o", output} + parts);
  }
  std::string text(const std::string& file) const { return text_of(*this / file); }
};

} // namespace

TEST_CASE("parts of an image are joined to the bytes of one run: formats, numbers of parts, AOVs, crops") {
  const Parts folder;
  const Words size = {"--size", "75x53"}; // neither side a multiple of a tile's
  struct Case {
    std::string output;
    int parts;
    Words options;
    Words beside = {}; // files of AOVs
  };
  const std::vector<Case> cases = {
      {"a.png", 1, {}},
      {"a.png", 4, {"--srgb"}},
      {"a.png", 60, {"--samples", "4"}}, // more than rows
      {"a.png", 3, {"--bits", "16"}},
      {"a.png", 3, {"--bits", "16", "--transparent", "--samples", "4"}},
      {"a.png", 2, {"--transparent", "--aov", "alpha,depth"}, {"a.alpha.pfm", "a.depth.pfm"}},
      {"a.png", 5, {"--aov", "uv,object", "--aov-format", "npy"}, {"a.uv.npy", "a.object.npy"}},
      {"a.png", 5, {"--crop", "11,7,50,31", "--aov", "depth"}, {"a.depth.pfm"}},
      {"a.jpg", 3, {"--quality", "80"}},
      {"a.npy", 3, {}},
      {"a.npy", 2, {"--bits", "8", "--transparent"}},
      {"a.hdr", 3, {"--aov", "normal"}, {"a.normal.pfm"}},
      {"a.pfm", 3, {"--aov", "triangle,uv"}, {"a.triangle.pfm", "a.uv.pfm"}},
      {"a.exr", 3, {"--aov", "position,material", "--precision", "float"}, {"a.position.exr", "a.material.exr"}},
      {"a.exr", 4, {"--layers", "--transparent", "--samples", "4"}},
      {"a.exr", 4, {"--layers", "--aov", "triangle,normal", "--aov-filter", "resolve", "--samples", "4"}},
  };
  for (const Case& one : cases) {
    std::string words;
    for (const std::string& word : one.options) words += " " + word;
    INFO(one.output, " in ", one.parts, ":", words);
    const Words all = size + one.options;
    REQUIRE(folder.run(Words{"render", "s.json", "-o", one.output} + all).exit_code == 0);
    const Words parts = folder.render(one.output, one.parts, all);
    const std::string joined = "joined" + one.output.substr(1);
    const Finished done = folder.assemble(parts, joined);
    REQUIRE_MESSAGE(done.exit_code == 0, done.err);
    CHECK(folder.text(joined) == folder.text(one.output));
    std::string expected = joined + "\n";
    for (const std::string& file : one.beside) {
      CHECK(folder.text("joined" + file.substr(1)) == folder.text(file));
      expected += "joined" + file.substr(1) + "\n";
    }
    CHECK(done.out == expected);
  }
}

TEST_CASE("parts of whole numbers are what render writes to another format of these") {
  const Parts folder;
  const Words parts = folder.render("a.png", 2, {"--size", "40x30"});
  REQUIRE(folder.run({"render", "s.json", "-o", "b.jpg", "--size", "40x30"}).exit_code == 0);
  REQUIRE(folder.assemble(parts, "c.jpg").exit_code == 0);
  CHECK(folder.text("c.jpg") == folder.text("b.jpg"));
  for (const char* const name : {"a.exr", "a.npy", "a.gif", "a"}) {
    INFO(name);
    const Finished refused = folder.assemble(parts, name);
    CHECK(refused.exit_code == 2);
    CHECK(refused.err.find("--output: found \"" + std::string(name) + "\", expected a name") != std::string::npos);
  }
}

TEST_CASE("what is missing, there twice, or of another image is said, and what was there stays") {
  const Parts folder;
  const Words size = {"--size", "40x30"};
  const Words parts = folder.render("a.png", 3, size); // from the last to the first
  save_text(folder / "out.png", "as it was");
  const auto refused = [&](const Words& list, const std::string& text) {
    const Finished run = folder.assemble(list, "out.png");
    INFO(run.err);
    CHECK(run.exit_code == 3);
    CHECK(run.err.find(text) != std::string::npos);
    CHECK(folder.text("out.png") == "as it was");
  };
  refused({parts[0], parts[2]}, "a.png.part-1-of-3: shard: found no part 2/3 beside it, expected all 3 parts");
  refused(parts + Words{parts[1]},
          "a.png.part-2-of-3: shard: found 2/3 a second time, expected each part once: a.png.part-2-of-3 is it too");
  refused(parts + Words{folder.render("b.png", 2, size)[0]},
          "b.png.part-2-of-2: shard: found 2/2, expected one of 3, as a.png.part-1-of-3 is");

  // Each with one part of another run.
  const auto with = [&](const Words& options, const std::string& text) {
    refused({parts[0], parts[1], folder.render("b.png", 3, options)[2]}, "b.png.part-1-of-3: " + text);
  };
  with(size + Words{"--precision", "float"}, "precision: found float, expected double, as a.png.part-3-of-3 has it");
  with({"--size", "40x31"}, "size: found 40x31, expected 40x30");
  with(size + Words{"--srgb"}, "srgb: found yes, expected no");
  with(size + Words{"--aov", "depth"}, "aov: found depth, expected nothing");
  with(size + Words{"--crop", "0,0,40,29"}, "crop: found 0,0,40,29, expected 0,0,40,30");
  with(size + Words{"--exposure", "1"}, "scene: found ");
  with(size + Words{"--set", "/scene/objects/0/rotate_x=10"}, "scene: found ");
  with(size + Words{"--fov", "41"}, "cameras: found ");
  std::string other = ball_scene;
  other.replace(other.find("\"glossiness\": 20"), 16, "\"glossiness\": 21");
  save_text(folder / "s.json", other);
  with(size, "scene: found ");

  refused({"s.json", parts[1], parts[2]}, "s.json: found another file, expected a part of an image");
  refused({parts[0], "s.json", parts[2]}, "s.json: found another file, expected a part of an image");
  refused({parts[0], parts[1], "none"}, "none: ");
}

TEST_CASE("a part that is cut off, longer or changed in a byte is refused") {
  const Parts folder;
  const Words parts = folder.render("a.png", 2, {"--size", "40x30", "--aov", "depth"});
  const std::string whole = folder.text(parts[0]);
  for (const std::size_t size : {std::size_t{0}, std::size_t{5}, std::size_t{16}, std::size_t{40}, whole.size() - 1}) {
    save_text(folder / parts[0], whole.substr(0, size));
    INFO(size);
    CHECK(folder.assemble(parts, "out.png").exit_code == 3);
  }
  save_text(folder / parts[0], whole + "x");
  CHECK(folder.assemble(parts, "out.png").exit_code == 3);
  std::string changed = whole;
  changed.back() = static_cast<char>(changed.back() ^ 1);
  save_text(folder / parts[0], changed);
  const Finished run = folder.assemble(parts, "out.png");
  CHECK(run.exit_code == 3);
  CHECK(run.err.find("depth: found other values than were written") != std::string::npos);
  // Every byte of the header: an image, or a line; no mistake of our own.
  const std::size_t header_end = whole.find("\n}\n") + 3;
  for (std::size_t i = 0; i < header_end; i += 3) {
    changed = whole;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    save_text(folder / parts[0], changed);
    const Finished one = folder.assemble(parts, "out.png");
    INFO(i, one.err);
    CHECK((one.exit_code == 0 || one.exit_code == 3));
  }
  CHECK_FALSE(fs::exists(folder / "out.depth.png"));
  save_text(folder / parts[0], whole);
  CHECK(folder.assemble(parts, "out.png").exit_code == 0);
}

TEST_CASE("an image that is larger than the memory is joined all the same") {
  const Parts folder;
  save_text(folder / "s.json", empty_scene);
  const Words size = {"--size", "4096x2560"};
  const Words parts = folder.render("a.pfm", 8, size);
  const Finished done = folder.run(Words{"assemble", "-o", "b.pfm", "--max-memory", "64M", "--threads", "2"} + parts);
  REQUIRE_MESSAGE(done.exit_code == 0, done.err);
  CHECK(fs::file_size(folder / "b.pfm") > (std::size_t{100} << 20));
  CHECK(done.peak_bytes < (std::size_t{100} << 20));
  REQUIRE(folder.run(Words{"render", "s.json", "-o", "a.pfm"} + size).exit_code == 0);
  CHECK(folder.text("b.pfm") == folder.text("a.pfm"));
}

TEST_CASE("shards of a turntable are joined to the files of one run") {
  const Parts folder;
  const Words common = {"turntable", "s.json", "--size", "40x30", "--frames", "7"};
  REQUIRE(folder.run(common + Words{"-o", "one/####.png"}).exit_code == 0);
  Words reports;
  for (const std::string part : {"3", "1", "2"}) {
    const Finished done = folder.run(common + Words{"-o", "part" + part + "/####.png", "--shard", part + "/3"});
    REQUIRE_MESSAGE(done.exit_code == 0, done.err);
    reports.push_back("part" + part + "/turntable.json.part-" + part + "-of-3");
  }
  CHECK(files_in(folder).size() == 5);
  CHECK(fs::exists(folder / "part2/0005.png"));
  CHECK_FALSE(fs::exists(folder / "part2/0004.png"));
  const auto check_joined = [&](const Words& of, const std::string& output) {
    const Finished done = folder.assemble(of, output);
    REQUIRE_MESSAGE(done.exit_code == 0, done.err);
    for (int i = 1; i <= 7; ++i) {
      const std::string name = "/000" + std::to_string(i) + ".png";
      CHECK(folder.text(fs::path(output).parent_path().string() + name) == folder.text("one" + name));
    }
  };
  check_joined(reports, "joined/####.png");
  // Into the place of the one run, whose report is then the same to a byte.
  const std::string report = folder.text("one/turntable.json");
  fs::remove_all(folder / "one/turntable.json");
  check_joined(reports, "one/####.png");
  CHECK(folder.text("one/turntable.json") == report);
  // And a run goes on with them.
  CHECK(folder.run(common + Words{"-o", "one/####.png"}).err.find("7 of 7 frames are there") != std::string::npos);

  // Shards that share a folder.
  Words shared;
  for (const std::string part : {"1", "2"}) {
    REQUIRE(folder.run(common + Words{"-o", "shared/####.png", "--shard", part + "/2"}).exit_code == 0);
    shared.push_back("shared/turntable.json.part-" + part + "-of-2");
  }
  check_joined(shared, "shared/####.png");
  const Finished again = folder.run(common + Words{"-o", "shared/####.png", "--shard", "2/2"});
  CHECK(again.err.find("3 of 3 frames are there") != std::string::npos);
}

TEST_CASE("frames that are missing, changed or of other options are said, and nothing is written") {
  const Parts folder;
  const Words common = {"turntable", "s.json", "--size", "40x30", "--frames", "4"};
  Words reports;
  for (const std::string part : {"1", "2"}) {
    REQUIRE(folder.run(common + Words{"-o", "p/####.png", "--shard", part + "/2"}).exit_code == 0);
    reports.push_back("p/turntable.json.part-" + part + "-of-2");
  }
  const auto refused = [&](const Words& list, const std::string& text) {
    const Finished run = folder.assemble(list, "out/####.png");
    INFO(run.err);
    CHECK(run.exit_code == 3);
    CHECK(run.err.find(text) != std::string::npos);
    CHECK_FALSE(fs::exists(folder / "out"));
  };
  refused({reports[0]}, "shard: found no part 2/2 beside it");
  refused(reports + Words{reports[0]}, "shard: found 1/2 a second time");
  const std::string frame = folder.text("p/0003.png");
  save_text(folder / "p/0003.png", frame.substr(0, 100));
  refused(reports, "p/turntable.json.part-1-of-2: frame 3: found p/0003.png missing or other than it was written");
  fs::remove(folder / "p/0003.png");
  refused(reports, "frame 3: found p/0003.png missing");
  save_text(folder / "p/0003.png", frame);
  REQUIRE(folder.run(common + Words{"-o", "q/####.png", "--shard", "2/2", "--srgb"}).exit_code == 0);
  refused({reports[0], "q/turntable.json.part-2-of-2"}, "srgb: found yes, expected no");
  REQUIRE(folder.run(common + Words{"-o", "q/####.png"}).exit_code == 0);
  refused({reports[0], "q/turntable.json"}, "shard: found nothing, expected the report of a run with --shard");
  CHECK(folder.assemble(reports, "out/####.exr").exit_code == 2);
  CHECK(folder.assemble(reports, "out.png").exit_code == 2);
}

TEST_CASE("a film of shards is that of one run") {
  const Parts folder;
  const Words common = {"turntable", "s.json", "--size", "40x30", "--frames", "4"};
  const Finished direct = folder.run(common + Words{"-o", "x.mp4", "--shard", "1/2"});
  CHECK(direct.exit_code == 2);
  CHECK(direct.err.find("refraster assemble") != std::string::npos);
  if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) {
    MESSAGE("ffmpeg is not installed (scripts/setup film)");
    return;
  }
  REQUIRE(folder.run(common + Words{"-o", "one.mp4"}).exit_code == 0);
  Words reports;
  for (const std::string part : {"1", "2"}) {
    REQUIRE(folder.run(common + Words{"-o", "p/####.png", "--shard", part + "/2"}).exit_code == 0);
    reports.push_back("p/turntable.json.part-" + part + "-of-2");
  }
  REQUIRE(folder.assemble(reports, "two.mp4").exit_code == 0);
  CHECK(folder.text("two.mp4.json") == folder.text("one.mp4.json"));
  CHECK(folder.text("two.mp4") == folder.text("one.mp4"));
}

} // namespace refraster
