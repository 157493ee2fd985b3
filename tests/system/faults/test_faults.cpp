// Whatever fails: what is on disk is old or new, whole, and nothing else; and the exit code says what happened.

#include "app/sanitizer.h"
#include "tests/support/program/program.h"
#include "tests/support/program/scenes.h"
#include "tests/system/faults/disks.h"
#include "tests/system/faults/fault_runs.h"
#include "tests/system/faults/sandbox.h"

#include <doctest/doctest.h>

#include <csignal>
#include <filesystem>

using namespace refraster;
namespace fs = std::filesystem;

namespace {

void check(const std::vector<FaultRow>& rows) {
  for (const FaultRow& row : rows) {
    INFO(row.fault);
    CHECK(row.runs > 0);
    for (const std::string& wrong : row.wrong) CHECK_MESSAGE(false, wrong);
  }
}

} // namespace

TEST_CASE("whichever call fails, outputs are old or new and nothing is left" * doctest::skip(built_with_sanitizer)) {
  check(failing_calls(Effort::quick));
}

TEST_CASE("whichever allocation fails, one line says so" * doctest::skip(built_with_sanitizer)) {
  check(failing_allocations(Effort::quick));
}

TEST_CASE("a file that is gone, or something else, when it is opened behind its check is bad input" *
          doctest::skip(built_with_sanitizer)) {
  const TemporaryFolder folder;
  for (const std::string name : {"s.json", "m.obj"})
    for (const std::string replacement : {"unlink", "pipe", "folder"}) {
      std::error_code ignored;
      for (const char* const file : {"s.json", "m.obj"}) fs::remove_all(folder / file, ignored);
      save_text(folder / "s.json", ball_from_file());
      save_text(folder / "m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
      const Environment environment(
          {{"LD_PRELOAD", REFRASTER_FAULTY_CALLS}, {"REFRASTER_REPLACED", name + " " + replacement}});
      const Finished run = run_program(folder.path, {"render", "s.json", "-o", "i.png", "--size", "8x8"});
      INFO(name << " " << replacement << ": " << run.err);
      CHECK(run.exit_code == 3);
      CHECK(run.err.starts_with("refraster: " + name + ": found "));
      CHECK_FALSE(fs::exists(folder / "i.png"));
    }
}

TEST_CASE("standard output that cannot be written is exit code 4") {
  const TemporaryFolder folder;
  for (const std::string words : {"list limits", "brdf synth lambert -o t.binary", "brdf info t.binary", "mesh cube"}) {
    const std::string command = "cd " + folder.path.string() + " && " + program_command() + " " + words;
    if (words != "mesh cube") // whose one word is still in the pipe's buffer when nobody reads any more
      CHECK(WEXITSTATUS(std::system((command + " > /dev/full 2> err").c_str())) == 4);
    if (words.starts_with("brdf synth")) continue;
    CHECK(WEXITSTATUS(std::system((command + " > /dev/full 2> err").c_str())) == 4);
    CHECK(text_of(folder / "err") == "refraster: standard output: cannot write\n");
  }
}

TEST_SUITE("long") {
  TEST_CASE("the same in every command" * doctest::skip(built_with_sanitizer)) {
    check(failing_calls(Effort::whole));
    check(failing_allocations(Effort::whole));
    check(killed_at_calls(Effort::whole));
  }
}

TEST_SUITE("slow") {
  TEST_CASE("wherever the process is killed, outputs are old or new, and the next run is not harmed" *
            doctest::skip(built_with_sanitizer)) {
    check(killed_at_calls(Effort::quick));
    check(killed_at_random(60));
  }

  TEST_CASE("SIGINT and SIGTERM end everything that can take long with exit code 130 and leave nothing") {
    check(interrupted_runs(Effort::whole));
  }

  TEST_CASE("a disk that is full or may not be written, and a limit of file sizes: exit code 4, old files whole") {
    const std::vector<FaultRow> rows = bad_disks();
    if (rows.empty()) {
      MESSAGE("SKIPPED: no right to mount a small file system");
      return;
    }
    check(rows);
  }
}
