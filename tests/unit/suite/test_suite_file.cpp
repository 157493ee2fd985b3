// Suite files: keys, lists, patterns, names, and what is said of what is wrong.

#include <refraster/notes.h>

#include "suite/file/expand.h"
#include "suite/file/suite_reader.h"
#include "tests/support/program/program.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace refraster;
using namespace refraster::suite;

namespace {

std::vector<std::string> names_of(const Suite& suite) {
  std::vector<std::string> names;
  for (const Entry& entry : suite.entries) names.push_back(entry.name);
  return names;
}

struct SuiteFolder : TemporaryFolder {
  Suite read(const std::string& text) const {
    save_text(*this / "s.json", text);
    return read_suite(*this / "s.json");
  }
  /// The faults, each as it is printed, without the folder.
  std::vector<std::string> faults(const std::string& text) const {
    std::vector<std::string> lines;
    try {
      read(text);
    } catch (const InputError& error) {
      for (const InputFault& fault : error.faults()) lines.push_back(fault.text().substr(path.string().size() + 1));
    }
    return lines;
  }
};

} // namespace

TEST_CASE("every scene that a pattern matches, with every device and size, is an entry with a name of its own") {
  const SuiteFolder folder;
  for (const char* const name : {"b.json", "a.json", "c.obj"}) save_text(folder / name, "{}");
  const Suite suite = folder.read(R"({"entries": [
    {"scene": "[ab].json", "action": "verify", "device": ["llvmpipe", "softpipe"], "size": [[40, 30], [80, 60]]},
    {"scene": "c.obj", "name": "chair", "tags": ["model"]}]})");
  CHECK(names_of(suite) == std::vector<std::string>{"a@llvmpipe@40x30", "a@llvmpipe@80x60", "a@softpipe@40x30",
                                                    "a@softpipe@80x60", "b@llvmpipe@40x30", "b@llvmpipe@80x60",
                                                    "b@softpipe@40x30", "b@softpipe@80x60", "chair"});
  const Entry& third = suite.entries[2];
  CHECK(third.device == "softpipe");
  CHECK(third.size == PixelSize{40, 30});
  CHECK(third.scene == (folder / "a.json"));
  CHECK(third.needs_gl());
  CHECK(suite.entries.back().tags == std::vector<std::string>{"model"});
  CHECK(suite.entries.back().action == Action::compare);
}

TEST_CASE("what entries do not say is as the defaults say; tags are added to theirs") {
  const SuiteFolder folder;
  const Suite suite = folder.read(R"({"references": "refs",
    "defaults": {"size": [64, 36], "samples": 4, "precision": "float", "tags": ["all"], "limits": {"max_abs": 2},
                 "timeout_seconds": 5, "max_memory_mib": 128, "srgb": true},
    "entries": [{"scene": "a.json", "tags": ["one"]}, {"scene": "b.json", "samples": 1, "limits": {"max_count": 3}}]})");
  REQUIRE(suite.entries.size() == 2);
  CHECK(suite.references == (folder / "refs"));
  const Entry &a = suite.entries[0], &b = suite.entries[1];
  CHECK(a.size == PixelSize{64, 36});
  CHECK(a.samples == 4);
  CHECK(b.samples == 1);
  CHECK(a.precision == Precision::float_);
  CHECK(a.transfer == Transfer::srgb);
  CHECK(a.tags == std::vector<std::string>{"all", "one"});
  CHECK(a.timeout_seconds == 5);
  CHECK(a.max_memory_mib == 128);
  CHECK(a.limits.compare.max_abs == 2);
  CHECK_FALSE(a.limits.compare.max_count);
  CHECK(b.limits.compare.max_count == 3);
}

TEST_CASE("all faults of a suite file are said at once, each with its place and the word that was meant") {
  const SuiteFolder folder;
  const std::vector<std::string> faults =
      folder.faults("{\n"
                    " \"entries\": [\n"
                    "  {\"scene\": \"a.json\", \"acton\": \"compare\"},\n"
                    "  {\"scene\": \"a.json\", \"action\": \"verfy\"},\n"
                    "  {\"scene\": 3, \"size\": [0, 4], \"samples\": [1, 3]},\n"
                    "  {\"scene\": \"a.json\", \"limits\": {\"fail_on\": {\"egde\": 1}}}\n"
                    " ], \"default\": {}}");
  REQUIRE(faults.size() == 7);
  CHECK(faults[0].starts_with("s.json:3:23: /entries/0/acton: found an unknown key, expected one of"));
  CHECK(faults[0].ends_with("; did you mean action?"));
  CHECK(faults[1].starts_with("s.json:4:33: /entries/1/action: found \"verfy\", expected"));
  CHECK(faults[1].ends_with("; did you mean verify?"));
  CHECK(faults[2].starts_with("s.json:5:13: /entries/2/scene: found 3, expected a string, or a list of such"));
  CHECK(faults[3].find("/entries/2/size") != std::string::npos);
  CHECK(faults[4].find("/entries/2/samples/1: found 3, expected 1, 2, 4, 8 or 16") != std::string::npos);
  CHECK(faults[5].ends_with("; did you mean edge?"));
  CHECK(faults[6].ends_with("; did you mean defaults?"));
}

TEST_CASE("a pattern that nothing matches, a name given twice and a digest of what differs from machine to machine are "
          "faults") {
  const SuiteFolder folder;
  const std::vector<std::string> faults = folder.faults(
      R"({"entries": [{"scene": "x*.json"}, {"scene": "a.json", "name": "n"}, {"scene": "b.json", "name": "n"},
          {"scene": "c.json", "reference": "digest", "precision": "fast"},
          {"scene": "d.json", "reference": "digest", "image": "gl"}, {"scene": "e.json", "image": "gl-float"}]})");
  REQUIRE(faults.size() == 5);
  CHECK(faults[0].find("found \"x*.json\", expected a pattern that a file matches") != std::string::npos);
  CHECK(faults[1].find("/entries/3: found a digest of the precision fast") != std::string::npos);
  CHECK(faults[2].find("/entries/4: found a digest of an image that is not rendered here") != std::string::npos);
  CHECK(faults[3].find("/entries/5: found floats of OpenGL to compare") != std::string::npos);
  CHECK(faults[4].find("the name \"n\" a second time") != std::string::npos);
}

TEST_CASE("scenes of one name are told apart by their folders, whichever comes first") {
  const auto names = [](const std::vector<std::string>& scenes) { return names_of(suite_of_scenes(scenes, {})); };
  CHECK(names({"a/model.obj", "b/model.obj", "c/x.json"}) == std::vector<std::string>{"a-model", "b-model", "x"});
  CHECK(names({"b/model.obj", "c/x.json", "a/model.obj"}) == std::vector<std::string>{"b-model", "x", "a-model"});
  CHECK(names({"p/a/m.obj", "q/a/m.obj"}) == std::vector<std::string>{"p-a-m", "q-a-m"});
  CHECK_THROWS_AS(names({"a.json", "a.json"}), InputError);
}

TEST_CASE("a name of an entry is a file name, whatever its scene is called") {
  CHECK(file_name_of("a b/ü") == "a_b___");
  CHECK(file_name_of("../x") == "_.._x");
  CHECK(file_name_of("") == "_");
  CHECK(file_name_of(std::string(500, 'n')).size() == 128);
}
