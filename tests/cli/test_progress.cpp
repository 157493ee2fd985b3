// The line that says how far something is.

#include "program.h"
#include "scenes.h"

#include <doctest/doctest.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

using namespace refraster;

namespace {

/// A terminal that a program may print to; what it shows can be read.
class Terminal {
public:
  Terminal() : screen_(posix_openpt(O_RDWR | O_NOCTTY)) {
    REQUIRE((screen_ >= 0 && grantpt(screen_) == 0 && unlockpt(screen_) == 0));
    path_ = ptsname(screen_);
    device_ = open(path_.c_str(), O_RDWR | O_NOCTTY); // held open, so that reading waits for what comes
    REQUIRE(device_ >= 0);
  }
  ~Terminal() {
    close(device_);
    close(screen_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  const std::string& path() const { return path_; }

  /// Waits for the next output.
  std::string some() const {
    std::array<char, 4096> bytes{};
    const ssize_t count = read(screen_, bytes.data(), bytes.size());
    REQUIRE(count > 0);
    return {bytes.data(), static_cast<std::size_t>(count)};
  }
  /// What is there already.
  std::string rest() const {
    pollfd ready{screen_, POLLIN, 0};
    std::string text;
    while (poll(&ready, 1, 0) == 1) text += some();
    return text;
  }

private:
  int screen_, device_ = -1;
  std::string path_;
};

} // namespace

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
