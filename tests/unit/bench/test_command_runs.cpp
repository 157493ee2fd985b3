#include "bench/measure/command_runs.h"
#include "tests/support/emulated.h"
#include "tests/support/program/program.h"
#include "tests/support/program/scenes.h"

#include <doctest/doctest.h>

using namespace refraster;
using namespace refraster::bench;

namespace {

struct Commands {
  TemporaryFolder folder;
  CommandTask task;
  std::string failure;

  Commands() {
    save_text(folder / "ball.json", ball_scene);
    task = {program_words(), {folder / "ball.json", "--fov=30"}, 32, 18, 1, {"float", "double"}, {1, 2}};
  }

  std::vector<CommandResult> measured() {
    return measure_commands(task, {.warm_up = 1, .least = 2, .seconds = 0}, failure);
  }
};

} // namespace

TEST_CASE("each precision and number of threads is a process of its own, whose parts add up") {
  Commands commands;
  const std::vector<CommandResult> results = commands.measured();
  REQUIRE_MESSAGE(commands.failure.empty(), commands.failure);
  REQUIRE(results.size() == 4);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const CommandResult& result = results[i];
    CHECK(result.precision == (i < 2 ? "float" : "double"));
    CHECK(result.threads == (i % 2 == 0 ? 1 : 2));
    CHECK(result.repetitions == 2);
    // Each is a median of two, and so a mean, which is linear.
    CHECK(result.start_ms.median + result.read_ms.median + result.frame_ms.median + result.write_ms.median ==
          doctest::Approx(result.whole_ms.median));
    CHECK(result.start_ms.min > 0);
    CHECK(result.cpu_ms.min > 0);
  }
  CHECK(files_in(commands.folder) == std::vector<std::string>{"ball.json"});
}

TEST_CASE("a process that fails is no result but a reason") {
  Commands commands;
  commands.task.words = {commands.folder / "none.json"};
  CHECK(commands.measured().empty());
  CHECK(commands.failure == "refraster render ended with exit code 3");
}

TEST_CASE("a program that cannot be started is no result but a reason") {
  if (test::skipped_in_emulator(test::no_failure_of_spawn)) return;
  Commands commands;
  commands.task.program = {commands.folder / "none"};
  CHECK(commands.measured().empty());
  CHECK(commands.failure == commands.folder / "none" + ": No such file or directory");
}
