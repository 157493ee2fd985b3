#pragma once
// A terminal for tests of what is printed only there.

#include "tests/support/program/program.h"

#include <doctest/doctest.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <string>
#include <unistd.h>

namespace refraster {

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

/// What two runs of one command, ended by SIGINT, showed on a terminal of their own, and how they ended.
struct OnTerminal {
  std::string shown, shown_quietly; // the second with -q
  int exit_code = -1, exit_code_quietly = -1;
};

/// Ends both as soon as the first has shown `text`: the command must take long.
inline OnTerminal interrupt_on_terminal(const std::filesystem::path& folder, const std::vector<std::string>& command,
                                        const std::string& text) {
  const Terminal terminal, quiet_terminal;
  // The quiet one first: that it is quiet it must have read before it is ended.
  std::vector<std::string> quietly = command;
  quietly.push_back("-q");
  Running quiet(folder, quietly, quiet_terminal.path());
  Running run(folder, command, terminal.path());
  OnTerminal result;
  while (result.shown.find(text) == std::string::npos) result.shown += terminal.some();
  for (const Running* one : {&run, &quiet}) one->send(SIGINT);
  result.exit_code = run.wait().exit_code;
  result.exit_code_quietly = quiet.wait().exit_code;
  result.shown += terminal.rest();
  result.shown_quietly = quiet_terminal.rest();
  return result;
}

} // namespace refraster
