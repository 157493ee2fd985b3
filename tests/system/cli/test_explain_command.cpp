// refraster explain, as a user runs it; and docs/explain.md, which shows what it prints.

#include <refraster/files.h>

#include "tests/support/files/page_part.h"
#include "tests/support/program/program.h"
#include "tests/support/program/scenes.h"
#include "tests/support/text.h"

#include <rapidjson/document.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <sstream>

using namespace refraster;

namespace {

using Words = std::vector<std::string>;
using Json = rapidjson::Document;

struct BallFolder : TemporaryFolder {
  BallFolder() { save_text(*this / "ball.json", ball_scene); }

  Finished explain(Words more) const {
    Words words = {"explain", "ball.json"};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(path, words);
  }
};

std::size_t lines_of(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

Json parsed(const std::string& text) {
  Json json;
  json.Parse<rapidjson::kParseFullPrecisionFlag>(text.c_str());
  REQUIRE_FALSE(json.HasParseError());
  return json;
}

/// Every name of a member, at any depth, but for those of a material's parameters, which the material names.
void add_names(const rapidjson::Value& value, std::set<std::string>& names) {
  if (value.IsArray())
    for (const auto& item : value.GetArray()) add_names(item, names);
  if (!value.IsObject()) return;
  for (const auto& member : value.GetObject()) {
    const std::string name = member.name.GetString();
    names.insert(name);
    if (name != "parameters" && name != "undefined" && name != "refraster") add_names(member.value, names);
  }
}

/// The words that a part of a page has between backticks.
std::set<std::string> code_words(const std::string& text) {
  std::set<std::string> words;
  for (std::size_t at = text.find('`'); at != std::string::npos;) {
    const std::size_t end = text.find('`', at + 1);
    if (end == std::string::npos) break;
    words.insert(text.substr(at + 1, end - at - 1));
    at = text.find('`', end + 1);
  }
  return words;
}

/// Without the lines of the precision `fast`, which is not the same on every machine.
std::string same_everywhere(const std::string& text) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with("  fast ")) result += line + "\n";
  return result;
}

std::string without_fence(const std::string& part) {
  const std::string fence = "```\n";
  const std::size_t begin = part.find(fence) + fence.size();
  return part.substr(begin, part.rfind(fence) - begin);
}

} // namespace

TEST_CASE("a pixel's story is text of 80 columns, in the order of the pipeline") {
  const BallFolder folder;
  const Finished run = folder.explain({"160", "90", "--size", "320x180"});
  CHECK(run.exit_code == 0);
  CHECK(run.err.empty());
  std::size_t at = 0;
  for (const char* const part : {"Pixel (160, 90) of 320x180", "COVERAGE", "SURFACE", "MATERIAL phong", "POINT LIGHT 0",
                                 "DIRECTION LIGHT 0", "SUM", "PRECISION"}) {
    const std::size_t found = run.out.find(part, at);
    CHECK_MESSAGE(found != std::string::npos, part);
    at = std::min(found, run.out.size());
  }
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) CHECK_MESSAGE(line.size() <= 80, line);
}

TEST_CASE("a pixel that the image does not have is wrong usage: one line, exit code 2") {
  const BallFolder folder;
  for (const Words& words : {Words{"320", "0", "--size", "320x180"}, Words{"0", "180", "--size", "320x180"},
                             Words{"-1", "0"}, Words{"1280", "0"}, Words{"0", "720"}, Words{"a", "0"}}) {
    const Finished run = folder.explain(words);
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    CHECK(lines_of(run.err) == 2); // the second says whose --help says more
    CHECK_MESSAGE((run.err.starts_with("refraster: X: found ") || run.err.starts_with("refraster: Y: found ")),
                  run.err);
  }
  CHECK(holds(folder.explain({"320", "0", "--size", "320x180"}).err, "found 320, expected 0 to 319"));
  CHECK(folder.explain({"1"}).exit_code == 2);
  CHECK(folder.explain({"1", "1", "--layer", "a"}).exit_code == 2);
}

TEST_CASE("the image of --actual decides the size; its pixel is explained, or is the same") {
  const BallFolder folder;
  REQUIRE(run_program(folder.path, {"render", "ball.json", "--size", "160x90", "-o", "same.png"}).exit_code == 0);
  std::string changed = ball_scene;
  const std::string quadratic = R"("quadratic": 0.2)";
  save_text(folder.path / "changed.json",
            changed.replace(changed.find(quadratic), quadratic.size(), R"("quadratic": 0)"));
  REQUIRE(run_program(folder.path, {"render", "changed.json", "--size", "160x90", "-o", "changed.pfm"}).exit_code == 0);

  const Finished same = folder.explain({"60", "40", "--actual", "same.png"});
  CHECK(same.exit_code == 0);
  CHECK(holds(same.out, "of 160x90"));
  CHECK(holds(same.out, "The actual value is what double rounds to"));
  const Finished other = folder.explain({"60", "40", "--actual", "changed.pfm"});
  CHECK(holds(other.out, "the attenuation of point light 0: 1 instead of"));
  CHECK(holds(other.out, "(as if it were not\n    attenuated)"));

  CHECK(folder.explain({"160", "40", "--actual", "same.png"}).exit_code == 2);
  const Finished wrong_size = folder.explain({"60", "40", "--actual", "same.png", "--size", "320x180"});
  CHECK(wrong_size.exit_code == 2);
  CHECK(holds(wrong_size.err, "160x90"));
  CHECK(folder.explain({"60", "40", "--actual", "none.png"}).exit_code == 3);
  save_text(folder.path / "text.png", "no image");
  CHECK(folder.explain({"60", "40", "--actual", "text.png"}).exit_code == 3);
}

TEST_CASE("through the sRGB curve the levels are those of render --srgb") {
  const BallFolder folder;
  REQUIRE(run_program(folder.path, {"render", "ball.json", "--size", "160x90", "--srgb", "-o", "a.png"}).exit_code ==
          0);
  const Finished run = folder.explain({"60", "40", "--actual", "a.png", "--srgb"});
  CHECK(holds(run.out, "The actual value is what double rounds to"));
  CHECK(holds(run.out, "sRGB"));
  CHECK_FALSE(
      holds(folder.explain({"60", "40", "--actual", "a.png"}).out, "The actual value is what double rounds to"));
}

TEST_CASE("--json has the story in full; every member is in docs/reports.md") {
  const BallFolder folder;
  REQUIRE(run_program(folder.path, {"render", "ball.json", "--size", "160x90", "-o", "a.pfm"}).exit_code == 0);
  const std::string page = read_file(REFRASTER_SOURCE_DIR "/docs/reports.md", "the documentation", 1 << 20);
  const std::size_t from = page.find("## `refraster explain"), to = page.find("\n## ", from + 1);
  REQUIRE(from != std::string::npos);
  const std::set<std::string> documented = code_words(page.substr(from, to - from));
  const std::string nylon = REFRASTER_SOURCE_DIR "/scenes/gallery/nylon.json",
                    filters = REFRASTER_SOURCE_DIR "/scenes/gallery/filters.json";
  std::set<std::string> names;
  for (const Words& words : {Words{"ball.json", "60", "40", "--actual", "a.pfm"}, Words{"ball.json", "0", "0"},
                             Words{nylon, "700", "270"}, Words{filters, "900", "420"}}) {
    Words all = {"explain", "--json", "-"};
    all.insert(all.end(), words.begin(), words.end());
    const Finished run = run_program(folder.path, all);
    REQUIRE_MESSAGE(run.exit_code == 0, run.err);
    const Json json = parsed(run.out);
    CHECK(json["schema"].GetInt() == 2);
    add_names(json, names);
  }
  for (const std::string& name : names) CHECK_MESSAGE(documented.count(name) == 1, name);
  CHECK(names.size() > 60);

  const Finished run = folder.explain({"60", "40", "--size", "160x90", "--json", "r.json"});
  CHECK(run.out.starts_with("Pixel (60, 40)"));
  const Json json = parsed(text_of(folder / "r.json"));
  const auto& fragment = json["fragments"][0];
  for (rapidjson::SizeType c = 0; c < 3; ++c) {
    double sum = fragment["ambient"][c].GetDouble();
    for (const auto& light : fragment["lights"].GetArray()) sum += light["reflected"][c].GetDouble();
    CHECK(sum == json["precisions"]["double"]["radiance"][c].GetDouble());
  }
  CHECK(folder.explain({"60", "40", "--json", "none/r.json"}).exit_code == 4);
}

TEST_CASE("docs/explain.md shows what the command prints") {
  const BallFolder folder;
  const std::string hello = text_of(REFRASTER_SOURCE_DIR "/scenes/hello.json");
  save_text(folder.path / "hello.json", hello);
  Finished run = run_program(folder.path, {"explain", "hello.json", "290", "80", "--size", "640x360"});
  CHECK(same_everywhere(run.out) ==
        same_everywhere(without_fence(test::page_part("docs/explain.md", "explain hello"))));

  std::string wrong = hello;
  const std::string glossiness = R"("glossiness": 90)";
  save_text(folder.path / "wrong.json",
            wrong.replace(wrong.find(glossiness), glossiness.size(), R"("glossiness": 60)"));
  REQUIRE(run_program(folder.path, {"render", "wrong.json", "--size", "640x360", "-o", "actual.png"}).exit_code == 0);
  run = run_program(folder.path, {"explain", "hello.json", "290", "80", "--actual", "actual.png"});
  const std::size_t at = run.out.find("ACTUAL");
  REQUIRE(at != std::string::npos);
  CHECK(run.out.substr(at) == without_fence(test::page_part("docs/explain.md", "explain actual")));
}

TEST_CASE("with --device the story has what a right device may have, around the pixel's own value, and why") {
  const BallFolder folder;
  const Words pixel = {"160", "90", "--size", "320x180", "--json", "-"};
  Words with = pixel;
  with.insert(with.end(), {"--device", "llvmpipe"});
  const Finished without = folder.explain(pixel), found = folder.explain(with);
  REQUIRE(found.exit_code == 0);
  CHECK(parsed(without.out)["bounds"].IsNull());
  const Json story = parsed(found.out);
  const auto& bounds = story["bounds"];
  REQUIRE(bounds.IsObject());
  double sum = 0, last = 1;
  for (const auto& cause : bounds["causes"].GetArray()) {
    CHECK(cause["fraction"].GetDouble() <= last);
    last = cause["fraction"].GetDouble();
    sum += last;
  }
  CHECK(sum > 0.97); // those below half a percent are left out
  CHECK(sum <= 1 + 0x1p-50);
  for (rapidjson::SizeType c = 0; c < 3; ++c) {
    const double value = story["precisions"]["double"]["radiance"][c].GetDouble();
    CHECK(bounds["least"][c].GetDouble() <= value);
    CHECK(value <= bounds["most"][c].GetDouble());
  }
  Words unknown = pixel;
  unknown.insert(unknown.end(), {"--device", "llvmpip"});
  CHECK(folder.explain(unknown).exit_code == 3);
}
