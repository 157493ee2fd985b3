// The line that says how far something is.

#include "tests/support/program/program.h"
#include "tests/support/program/scenes.h"
#include "tests/support/program/terminal.h"

#include <doctest/doctest.h>

using namespace refraster;

TEST_CASE("on a terminal, what takes more than a second says how far it is, and wipes that; with -q it says nothing") {
  const TemporaryFolder folder;
  save_text(folder / "ball.json", ball_scene);
  // Far more than a second's work on any machine; it is given up when it has said how far it is.
  const OnTerminal found = interrupt_on_terminal(
      folder.path, {"render", "ball.json", "--size", "8192x8192", "--samples", "16", "--threads", "1"}, "%");
  CHECK(found.shown.find("rendering") != std::string::npos);
  CHECK(found.exit_code == 130);
  CHECK(found.shown.ends_with("\r\033[K"));
  CHECK(found.exit_code_quietly == 130);
  CHECK(found.shown_quietly.empty());
}
