// The line that says how far something is.

#include "tests/support/program/program.h"
#include "tests/support/program/scenes.h"
#include "tests/support/program/terminal.h"

#include <doctest/doctest.h>

#include <csignal>

using namespace refraster;

TEST_CASE("on a terminal, what takes more than a second says how far it is, and wipes that; with -q it says nothing") {
  const TemporaryFolder folder;
  save_text(folder / "ball.json", ball_scene);
  // Far more than a second's work on any machine; it is given up when it has said how far it is.
  const std::vector<std::string> long_frame = {"render",    "ball.json", "--size",    "8192x8192",
                                               "--samples", "16",        "--threads", "1"};
  std::vector<std::string> quiet_frame = long_frame;
  quiet_frame.push_back("-q");

  const Terminal terminal, quiet_terminal;
  Running quiet(folder.path, quiet_frame, quiet_terminal.path());
  Running run(folder.path, long_frame, terminal.path());
  std::string text;
  while (text.find('%') == std::string::npos) text += terminal.some();
  CHECK(text.find("rendering") != std::string::npos);
  for (const Running* frame : {&run, &quiet}) frame->send(SIGINT);
  CHECK(run.wait().exit_code == 130);
  CHECK((text + terminal.rest()).ends_with("\r\033[K"));
  CHECK(quiet.wait().exit_code == 130);
  CHECK(quiet_terminal.rest().empty());
}
