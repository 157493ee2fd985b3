// What a user reads about each malformed file: one line a fault, exit code 3, and nothing on standard output.

#include "tests/support/program/program.h"

#include <doctest/doctest.h>

using namespace refraster;

namespace {

/// How the command line reaches a reader; empty for readers that only a scene reaches.
std::vector<std::string> command_for(test::Reader reader, const std::string& input) {
  switch (reader) {
  case test::Reader::scene:
    return {"render", input, "-o", "never.png"};
  case test::Reader::image:
    return {"compare", input, input};
  case test::Reader::merl:
    return {"brdf", "info", input};
  case test::Reader::obj:
  case test::Reader::texture:
    return {};
  }
  return {};
}

} // namespace

TEST_CASE("every malformed file is named with its place, what was found and what was expected") {
  int reached = 0;
  for (const test::MalformedInput& bad : test::malformed_inputs()) {
    const std::vector<std::string> words = command_for(bad.reader, bad.input);
    if (words.empty()) continue;
    ++reached;
    const TemporaryFolder folder;
    test::write_files(folder.path, bad.files);
    const Finished run = run_program(folder.path, words);
    INFO(bad.name);
    CHECK(run.exit_code == 3);
    CHECK_MESSAGE(run.err.starts_with("refraster: " + bad.expected + "\n"), run.err); // advice may follow
    CHECK(run.out.empty());
    CHECK_FALSE(std::filesystem::exists(folder / "never.png"));
  }
  CHECK(reached >= 40);
}
