// refraster suite run, update: references, what is done again, states, results.

#include "io/file/text.h"
#include "tests/support/program/json_schema.h"
#include "tests/support/program/scenes.h"
#include "tests/system/suite/suite_runs.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

using namespace refraster;
using namespace refraster::test;

namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> all_of(int scenes, const std::string& state) {
  std::map<std::string, std::string> states;
  for (int i = 0; i < scenes; ++i) states["s" + std::to_string(i)] = state;
  return states;
}

} // namespace

TEST_CASE("without references every entry says so; update makes them; then all are equal, and none is done again") {
  const SuiteFolder folder(4);
  const Finished first = folder.run();
  CHECK(first.exit_code == 1);
  CHECK(first.out.starts_with("4 no reference in "));
  CHECK(folder.states() == all_of(4, "no reference"));
  CHECK(fs::exists(folder / "results/images/s0.png"));

  const Finished update = folder.update({"--reason", "first light"});
  CHECK(update.exit_code == 0);
  CHECK(update.out == "s0: new, 40x30\ns1: new, 40x30\ns2: new, 40x30\ns3: new, 40x30\n"
                      "4 added, 0 changed, 0 as before in refs\n");
  CHECK(text_of(folder / "refs/refs.json").find("\"reason\": \"first light\"") != std::string::npos);
  REQUIRE(run_program(folder.path, {"render", "s0.json", "--size", "40x30", "-o", "one.png"}).exit_code == 0);
  CHECK(text_of(folder / "refs/s0.png") == text_of(folder / "one.png"));

  const Finished second = folder.run();
  CHECK(second.exit_code == 0);
  CHECK(known_from_before(second) == 0);
  CHECK(folder.states() == all_of(4, "equal"));
  CHECK_FALSE(fs::exists(folder / "results/images/s0.png"));
  const Finished third = folder.run();
  CHECK(third.exit_code == 0);
  CHECK(known_from_before(third) == 4);
  CHECK(folder.states() == all_of(4, "equal"));
  CHECK(known_from_before(folder.run({"--no-cache"})) == 0);
}

TEST_CASE("a change of one glossiness is reported by the scene that shows it, and the others are not done again") {
  const SuiteFolder folder(6);
  REQUIRE(folder.update().exit_code == 0);
  REQUIRE(folder.run().exit_code == 0);
  folder.change("s3.json", "\"glossiness\": 29", "\"glossiness\": 30");
  const Finished run = folder.run();
  CHECK(run.exit_code == 1);
  CHECK(known_from_before(run) == 5);
  auto expected = all_of(6, "equal");
  expected["s3"] = "different";
  CHECK(folder.states() == expected);
  CHECK(run.out.find("\n  s3: different: differ") != std::string::npos);
  for (const char* const file : {"results/images/s3.png", "results/images/s3.difference.png", "results/pages/s3.html"})
    CHECK_MESSAGE(fs::exists(folder / file), file);
  // Reported again, though it is known; and gone with the difference.
  CHECK(folder.run().exit_code == 1);
  const Finished update = folder.update({"--only", "s3"});
  CHECK(update.out.starts_with("s3: "));
  CHECK(update.out.find("0 added, 1 changed, 0 as before in refs\n") != std::string::npos);
  const Finished again = folder.run();
  CHECK(again.exit_code == 0);
  CHECK(known_from_before(again) == 5);
  CHECK_FALSE(fs::exists(folder / "results/pages/s3.html"));
}

TEST_CASE("a mesh that a scene names, one that appears, and a reference that changes are inputs too") {
  const SuiteFolder folder(2);
  save_text(folder / "s0.json", ball_from_file());
  REQUIRE(run_program(folder.path, {"mesh", "cube", "-o", "m.obj"}).exit_code == 0);
  REQUIRE(folder.update().exit_code == 0);
  REQUIRE(folder.run().exit_code == 0);
  REQUIRE(run_program(folder.path, {"mesh", "torus", "-o", "m.obj"}).exit_code == 0);
  const Finished run = folder.run();
  CHECK(known_from_before(run) == 1);
  CHECK(folder.states()["s0"] == "different");
  fs::remove(folder / "m.obj");
  CHECK(folder.run().exit_code == 3);
  CHECK(folder.states()["s0"] == "bad input");
  REQUIRE(run_program(folder.path, {"mesh", "cube", "-o", "m.obj"}).exit_code == 0);
  CHECK(folder.run().exit_code == 0);
  fs::copy_file(folder / "refs/s0.png", folder / "refs/s1.png", fs::copy_options::overwrite_existing);
  CHECK(folder.run().exit_code == 1);
  CHECK(folder.states()["s1"] == "different");
}

TEST_CASE("an image that somebody puts where there was no reference is one") {
  const SuiteFolder folder(1);
  REQUIRE(folder.run().exit_code == 1);
  CHECK(known_from_before(folder.run()) == 1);
  fs::create_directories(folder / "refs");
  REQUIRE(run_program(folder.path, {"render", "s0.json", "--size", "40x30", "-o", "refs/s0.png"}).exit_code == 0);
  CHECK(folder.run().exit_code == 0);
}

TEST_CASE("a scene that is missing, one that is wrong, and a truncated reference stop no other entry") {
  const SuiteFolder folder(5);
  REQUIRE(folder.update().exit_code == 0);
  save_text(folder / "s1.json", "{\"scene\": {}}");
  fs::resize_file(folder / "refs/s2.png", 100);
  folder.change("s3.json", "\"glossiness\": 29", "\"glossiness\": 90");
  save_text(folder / "suite.json",
            R"({"references": "refs", "defaults": {"size": [40, 30]},
                "entries": [{"scene": "s?.json"}, {"scene": "none.json"}]})");
  const Finished run = run_program(folder.path, {"suite", "run", "suite.json"});
  CHECK(run.exit_code == 3);
  CHECK(folder.states() == std::map<std::string, std::string>{{"s0", "equal"},
                                                              {"s1", "bad input"},
                                                              {"s2", "bad input"},
                                                              {"s3", "different"},
                                                              {"s4", "equal"},
                                                              {"none", "bad input"}});
  const std::string json = text_of(folder / "results/results.json");
  CHECK(json.find("none.json: found no such file") != std::string::npos);
  CHECK(json.find("refs/s2.png") != std::string::npos);
  CHECK(run.out.find("  and 1 more\n") != std::string::npos);
}

TEST_CASE("a digest takes no image; one that fails says so, and shows the new one") {
  const SuiteFolder folder(2);
  REQUIRE(folder.update({"--reference", "digest"}).exit_code == 0);
  CHECK_FALSE(fs::exists(folder / "refs/s0.png"));
  REQUIRE(folder.run().exit_code == 0);
  folder.change("s1.json", "\"glossiness\": 23", "\"glossiness\": 24");
  const Finished run = folder.run();
  CHECK(run.exit_code == 1);
  CHECK(run.out.find("s1: different: other bits than its digest") != std::string::npos);
  CHECK(fs::exists(folder / "results/images/s1.png"));
  CHECK(text_of(folder / "results/results.json").find("no image of the old ones is kept") != std::string::npos);
  // It stays a digest; and becomes an image where that is asked for.
  CHECK(folder.update().out.find("s1: other bits") != std::string::npos);
  CHECK(folder.run().exit_code == 0);
  CHECK(folder.update({"--reference", "image"}).out.find("s0: was digest, is image") != std::string::npos);
  CHECK(folder.run().exit_code == 0);
}

TEST_CASE("an update of which one entry fails changes nothing") {
  const SuiteFolder folder(3);
  REQUIRE(folder.update().exit_code == 0);
  const std::string before = text_of(folder / "refs/refs.json"), image = text_of(folder / "refs/s0.png");
  folder.change("s0.json", "\"glossiness\": 20", "\"glossiness\": 99");
  save_text(folder / "s1.json", "{");
  const Finished update = folder.update();
  CHECK(update.exit_code == 3);
  CHECK(update.err.find("refraster: s1: ") == 0);
  CHECK(update.err.find("refraster: no reference is stored\n") != std::string::npos);
  CHECK(text_of(folder / "refs/refs.json") == before);
  CHECK(text_of(folder / "refs/s0.png") == image);
  CHECK(std::distance(fs::directory_iterator(folder / "refs"), fs::directory_iterator()) == 4);
}

TEST_CASE("an image of another size is different, whatever the limits are") {
  const SuiteFolder folder(1);
  REQUIRE(folder.update().exit_code == 0);
  const Finished run = run_program(
      folder.path, {"suite", "run", "s0.json", "--references", "refs", "--size", "20x15", "--max-abs", "255"});
  CHECK(run.exit_code == 1);
  CHECK(run.out.find("20x15 pixels, the reference 40x30") != std::string::npos);
}

TEST_CASE("limits let small differences pass") {
  const SuiteFolder folder(1);
  REQUIRE(folder.update().exit_code == 0);
  folder.change("s0.json", "\"glossiness\": 20", "\"glossiness\": 21");
  CHECK(folder.run().exit_code == 1);
  CHECK(folder.run({"--max-abs", "200"}).exit_code == 0);
}

TEST_CASE("an image of another program is held against its reference, and verified") {
  const SuiteFolder folder(1);
  REQUIRE(folder.update().exit_code == 0);
  fs::copy_file(folder / "refs/s0.png", folder / "other.png");
  save_text(folder / "suite.json", R"({"references": "refs", "entries": [
      {"scene": "s0.json", "image": "other.png"},
      {"scene": "s0.json", "name": "judged", "image": "other.png", "action": "verify"}]})");
  const auto run = [&] { return run_program(folder.path, {"suite", "run", "suite.json"}); };
  CHECK(run().exit_code == 0);
  CHECK(folder.states() == std::map<std::string, std::string>{{"s0", "equal"}, {"judged", "explained"}});
  REQUIRE(run_program(folder.path, {"render", "s0.json", "--size", "40x30", "-o", "other.png", "--set",
                                    "/scene/objects/0/material/glossiness=90"})
              .exit_code == 0);
  CHECK(run().exit_code == 1);
  CHECK(folder.states() == std::map<std::string, std::string>{{"s0", "different"}, {"judged", "unexplained"}});
  CHECK(fs::exists(folder / "results/pages/judged.html"));
}

TEST_CASE("results.json is what its schema says, and the summary as Markdown names what differs") {
  const SuiteFolder folder(3);
  REQUIRE(folder.update({"--only", "s0,s1"}).exit_code == 0);
  folder.change("s1.json", "\"glossiness\": 23", "\"glossiness\": 90");
  const Finished run = folder.run({"--markdown", "-"});
  CHECK(run.exit_code == 1);
  CHECK(run.out.starts_with("### refraster suite\n\n1 different, 1 no reference, 1 equal\n"));
  CHECK(run.out.find("| s1 | different | differ") != std::string::npos);
  const Json json = parsed(text_of(folder / "results/results.json"));
  const std::string schema = text_of(std::string(REFRASTER_SOURCE_DIR) + "/docs/suite.schema.json");
  CHECK(schema_fault(json, schema).empty());
  CHECK(json["exit_code"].GetInt() == 1);
  CHECK(json["counts"]["equal"].GetInt() == 1);
}

TEST_CASE("docs/suite.md has every key, state and member") {
  const std::string page = text_of(std::string(REFRASTER_SOURCE_DIR) + "/docs/suite.md");
  for (const suite::StateFacts& facts : suite::state_facts)
    CHECK_MESSAGE(page.find("| " + std::string(facts.name) + " |") != std::string::npos, facts.name);
  suite::EntryResult result;
  suite::EntryResult::fields(result, [&](std::string_view name, const auto&, suite::MemberOf where, std::string_view) {
    if (where == suite::MemberOf::report)
      CHECK_MESSAGE(page.find("`" + std::string(name) + "`") != std::string::npos, name);
  });
}

TEST_CASE("wrong usage is said, with the word that was meant") {
  const SuiteFolder folder(2);
  save_text(folder / "suite.json", R"({"entries": [{"scene": "s0.json", "tags": ["glossy"]}]})");
  const auto run = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"suite", "run"});
    return run_program(folder.path, words);
  };
  CHECK(run({}).exit_code == 2);
  CHECK(run({"suite.json", "--size", "4x4"}).exit_code == 2);
  CHECK(run({"suite.json", "--shard", "3/2"}).exit_code == 2);
  const Finished only = run({"suite.json", "--only", "glosy"});
  CHECK(only.exit_code == 2);
  CHECK(only.err.find("did you mean glossy?") != std::string::npos);
  const Finished broken = [&] {
    save_text(folder / "broken.json", "{\"entries\": [");
    return run({"broken.json"});
  }();
  CHECK(broken.exit_code == 3);
  CHECK(broken.err.find("broken.json:1:") != std::string::npos);
  CHECK(run_program(folder.path, {"suite", "update", "suite.json"}).exit_code == 2);
  CHECK(run_program(folder.path, {"suite", "merge", "nothing"}).exit_code == 3);
}
