#include "tests/system/suite/suite_runs.h"

#include "io/json/json.h"
#include "tests/support/program/scenes.h"

#include <doctest/doctest.h>

#include <cstdlib>

namespace refraster::test {

SuiteFolder::SuiteFolder(int scenes, const std::string& size) : size_(size) {
  for (int i = 0; i < scenes; ++i) {
    const std::string name = "s" + std::to_string(i) + ".json";
    save_text(*this / name, ball_scene);
    change(name, "\"glossiness\": 20", "\"glossiness\": " + std::to_string(20 + 3 * i));
  }
}

std::vector<std::string> SuiteFolder::words(const std::string& command, std::vector<std::string> more) const {
  std::vector<std::string> words = {"suite", command, "s*.json", "--references", "refs", "--size", size_};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

Finished SuiteFolder::update(const std::vector<std::string>& more) const {
  return run_program(path, words("update", more));
}

Finished SuiteFolder::run(const std::vector<std::string>& more) const {
  return run_program(path, words("run", more));
}

std::map<std::string, std::string> SuiteFolder::states(const std::string& results) const {
  std::map<std::string, std::string> states;
  const JsonDocument document("results.json", text_of(*this / (results + "/results.json")));
  for (JsonIndex i = document[0].first_child; i; i = document[i].next) {
    if (document[i].key != "entries") continue;
    for (JsonIndex entry = document[i].first_child; entry; entry = document[entry].next) {
      std::string name, state;
      for (JsonIndex member = document[entry].first_child; member; member = document[member].next) {
        if (document[member].key == "name") name = document[member].string;
        if (document[member].key == "state") state = document[member].string;
      }
      states[name] = state;
    }
  }
  return states;
}

void SuiteFolder::change(const std::string& scene, const std::string& from, const std::string& to) const {
  std::string text = text_of(*this / scene);
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  save_text(*this / scene, text.replace(at, from.size(), to));
}

int known_from_before(const Finished& run) {
  const std::size_t end = run.out.find(" known from before");
  if (end == std::string::npos) return 0;
  return std::atoi(run.out.c_str() + run.out.rfind('(', end) + 1);
}

} // namespace refraster::test
