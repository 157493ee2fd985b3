// refraster suite where it is killed, where disks are full, and where two of it are at work.

#include "tests/system/suite/suite_runs.h"

#include <doctest/doctest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <memory>
#include <random>
#include <thread>

#include <sys/resource.h>

using namespace refraster;
using namespace refraster::test;

namespace {

namespace fs = std::filesystem;

/// The text without every occurrence of a word.
std::string without(std::string text, const std::string& word) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at)) text.erase(at, word.size());
  return text;
}

/// What a folder of results holds but for journals and times: by file, its text, without what differs from run to run
/// and from folder to folder.
std::map<std::string, std::string> contents_of(const fs::path& folder) {
  std::map<std::string, std::string> contents;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = fs::relative(entry.path(), folder).string();
    if (!entry.is_regular_file() || name.starts_with("journal/")) continue;
    std::string text = text_of(entry.path());
    if (name == "results.json") {
      std::string stays;
      for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end + 1) {
        end = std::min(text.find('\n', begin), text.size());
        const std::string line = text.substr(begin, end - begin);
        bool is_of_run = false;
        for (const char* const member : {"\"seconds\"", "\"peak_bytes\"", "\"finished\""})
          is_of_run = is_of_run || line.find(member) != std::string::npos;
        if (!is_of_run) stays += line + "\n";
      }
      text = stays;
    }
    if (name.starts_with("pages/")) text = without(text, folder.filename().string() + "/"); // in names of images
    if (name == "junit.xml" || name == "index.html") text = "there";                        // with times everywhere
    contents[name] = text;
  }
  return contents;
}

/// Kills a run after a random time, again and again, and goes on; then all must be as in a run that nothing befell.
void kill_and_go_on(int kills, int scenes, std::uint64_t seed) {
  const SuiteFolder folder(scenes, "120x90");
  REQUIRE(folder.update().exit_code == 0);
  folder.change("s1.json", "\"glossiness\": 23", "\"glossiness\": 24");
  const Finished whole = folder.run({"-o", "whole"});
  REQUIRE(whole.exit_code == 1);
  const auto before = std::chrono::steady_clock::now();
  folder.run({"-o", "timed"});
  const double whole_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> moment(0, whole_seconds);
  for (int i = 0; i < kills; ++i) {
    Running run(folder.path, folder.words("run", {"--resume"}));
    std::this_thread::sleep_for(std::chrono::duration<double>(moment(random)));
    run.send(SIGKILL);
    run.wait();
    // Whatever stands there is whole.
    if (fs::exists(folder / "results/results.json")) CHECK(folder.states().size() == static_cast<std::size_t>(scenes));
    const suite::KnownResults known = suite::read_journals(folder / "results");
    for (const auto& result : known.latest)
      CHECK_MESSAGE(suite::facts_of(result.second.state).is_repeatable, result.first << ": " << result.second.message);
    std::error_code busy; // its workers end a moment later
    if (i % 8 == 7)       // from the beginning once more
      while (fs::exists(folder / "results")) fs::remove_all(folder / "results", busy);
  }
  CHECK(folder.run({"--resume"}).exit_code == 1);
  CHECK(contents_of(folder / "results") == contents_of(folder / "whole"));
}

} // namespace

TEST_CASE("a run that is killed goes on where it was, and ends as if nothing had been") {
  kill_and_go_on(3, 8, 1);
}

TEST_SUITE("slow") {
  TEST_CASE("a run that is killed at a hundred random moments goes on, and ends as if nothing had been") {
    kill_and_go_on(100, 24, 2);
  }
}

TEST_CASE("an interrupted run says so, leaves no process and no half, and goes on") {
  const SuiteFolder folder(2);
  REQUIRE(folder.update().exit_code == 0);
  // Two that end at once, and one that does not.
  save_text(folder / "suite.json", R"({"references": "refs", "defaults": {"size": [40, 30]}, "entries": [
      {"scene": "s?.json"},
      {"scene": "s0.json", "name": "slow", "action": "render", "precision": "exact", "size": [4000, 4000]}]})");
  Running run(folder.path, {"suite", "run", "suite.json", "--jobs", "2"});
  while (suite::read_journals(folder / "results").latest.size() < 2)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  run.send(SIGINT);
  const Finished finished = run.wait();
  CHECK(finished.exit_code == 130);
  CHECK_FALSE(fs::exists(folder / "results/results.json"));
  const Finished again = run_program(folder.path, {"suite", "run", "suite.json", "--only", "s0,s1", "--resume"});
  CHECK(again.exit_code == 0);
  CHECK(known_from_before(again) == 2);
}

TEST_CASE("what takes for ever is ended after its time, and what takes too much memory is refused") {
  const SuiteFolder folder(2);
  REQUIRE(folder.update().exit_code == 0);
  save_text(folder / "suite.json", R"({"references": "refs", "defaults": {"size": [40, 30]}, "entries": [
      {"scene": "s?.json"},
      {"scene": "s0.json", "name": "slow", "action": "render", "precision": "exact", "size": [4000, 4000],
       "timeout_seconds": 1},
      {"scene": "s0.json", "name": "large", "action": "render", "size": [16384, 16384], "max_memory_mib": 256}]})");
  const Finished run = run_program(folder.path, {"suite", "run", "suite.json", "--max-memory", "600M"});
  CHECK(run.exit_code == 3);
  CHECK(folder.states() == std::map<std::string, std::string>{
                               {"s0", "equal"}, {"s1", "equal"}, {"slow", "timed out"}, {"large", "out of memory"}});
  // What took too long is tried again, but for where a run goes on.
  CHECK(known_from_before(
            run_program(folder.path, {"suite", "run", "suite.json", "--max-memory", "600M", "--resume"})) == 4);
}

TEST_CASE("two runs of one suite into one folder at once both end well, and leave what one would") {
  const SuiteFolder folder(8);
  REQUIRE(folder.update().exit_code == 0);
  folder.change("s2.json", "\"glossiness\": 26", "\"glossiness\": 27");
  REQUIRE(folder.run({"-o", "whole"}).exit_code == 1);
  for (int i = 0; i < 4; ++i) {
    fs::remove_all(folder / "results");
    Running one(folder.path, folder.words("run")), other(folder.path, folder.words("run"));
    CHECK(one.wait().exit_code == 1);
    CHECK(other.wait().exit_code == 1);
    CHECK(contents_of(folder / "results") == contents_of(folder / "whole"));
  }
}

TEST_CASE("where files may not be as large as they must, a run says so, and is whole the next time") {
  const SuiteFolder folder(6);
  REQUIRE(folder.update().exit_code == 0);
  folder.change("s2.json", "\"glossiness\": 26", "\"glossiness\": 27");
  REQUIRE(folder.run({"-o", "whole"}).exit_code == 1);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  for (const rlim_t most : {300u, 3000u, 12000u, 40000u}) {
    const rlimit limit{most, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
    const Finished run = folder.run();
    setrlimit(RLIMIT_FSIZE, &before);
    CHECK_MESSAGE(run.exit_code == 4, most << ": " << run.exit_code << " " << run.err);
  }
  CHECK(folder.run({"--resume"}).exit_code == 1); // what could not be written is tried again, too
  CHECK(contents_of(folder / "results") == contents_of(folder / "whole"));
}

TEST_CASE("a corrupt journal is noticed and not used") {
  const SuiteFolder folder(3);
  REQUIRE(folder.update().exit_code == 0);
  REQUIRE(folder.run().exit_code == 0);
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / "results/journal")) {
    std::string text = text_of(entry.path());
    text[text.find("s1.json", text.find("\"scene\""))] = 'x';
    save_text(entry.path(), text);
  }
  const Finished run = folder.run();
  CHECK(run.exit_code == 0);
  CHECK(run.err.find("cut off or corrupt, not used") != std::string::npos);
  CHECK(known_from_before(run) < 3);
  CHECK(folder.states().size() == 3);
}
