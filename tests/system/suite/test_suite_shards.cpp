// refraster suite run --shard, suite merge.

#include "tests/system/suite/suite_runs.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <memory>

using namespace refraster;
using namespace refraster::test;

namespace fs = std::filesystem;

TEST_CASE("shards in folders of their own are joined to what one run finds, pages included") {
  const SuiteFolder folder(7);
  REQUIRE(folder.update().exit_code == 0);
  folder.change("s3.json", "\"glossiness\": 29", "\"glossiness\": 30");
  CHECK(folder.run({"-o", "whole"}).exit_code == 1);
  std::vector<std::string> merge = {"suite", "merge", "-o", "joined"};
  int failing = 0;
  for (const std::string part : {"1", "2", "3"}) {
    failing += folder.run({"--shard", part + "/3", "-o", "part" + part}).exit_code;
    merge.push_back("part" + part);
  }
  CHECK(failing == 1);
  const Finished joined = run_program(folder.path, merge);
  CHECK(joined.exit_code == 1);
  CHECK(folder.states("joined") == folder.states("whole"));
  for (const char* const file : {"/images/s3.png", "/images/s3.difference.png", "/pages/s3.html"})
    CHECK(text_of(folder / (std::string("joined") + file)) == text_of(folder / (std::string("whole") + file)));
}

TEST_CASE("a shard that is missing is said, entry by entry") {
  const SuiteFolder folder(4);
  REQUIRE(folder.update().exit_code == 0);
  REQUIRE(folder.run({"--shard", "1/2", "-o", "part"}).exit_code == 0);
  const Finished joined = run_program(folder.path, {"suite", "merge", "part", "-o", "joined"});
  CHECK(joined.exit_code == 1);
  int missing = 0;
  for (const auto& [name, state] : folder.states("joined")) missing += state == "missing" ? 1 : 0;
  // How many are in a part follows from the times that their references took.
  CHECK((missing >= 1 && missing <= 3));
  CHECK(joined.out.starts_with(std::to_string(missing) + " missing, " + std::to_string(4 - missing) + " equal"));
}

TEST_CASE("results of one entry that contradict each other are said") {
  const SuiteFolder folder(2);
  REQUIRE(folder.update().exit_code == 0);
  REQUIRE(folder.run({"-o", "a"}).exit_code == 0);
  folder.change("s1.json", "0.1 0.2 0.3", "0.1 0.2 0.4");
  folder.run({"-o", "b"});
  const Finished joined = run_program(folder.path, {"suite", "merge", "a", "b", "-o", "joined"});
  CHECK(joined.exit_code == 1);
  CHECK(joined.out.find("s1: a and b have it of different files") != std::string::npos);
}

TEST_CASE("shards that share a folder end with the whole of it") {
  const SuiteFolder folder(6);
  REQUIRE(folder.update().exit_code == 0);
  std::vector<std::unique_ptr<Running>> running;
  for (const char* const part : {"1/3", "2/3", "3/3"})
    running.push_back(std::make_unique<Running>(folder.path, folder.words("run", {"--shard", part})));
  for (const auto& one : running) CHECK(one->wait().exit_code == 0);
  const auto states = folder.states();
  CHECK(states.size() == 6);
  for (const auto& state : states) CHECK_MESSAGE(state.second == "equal", state.first);
}
