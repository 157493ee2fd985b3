#pragma once
// How far a long frame is.

#include <chrono>
#include <string>

namespace refraster {

/// A line on stderr that counts up, from the second second on, if stderr is a terminal. Wiped when done.
class ProgressLine {
public:
  /// `doing` stands before the number.
  explicit ProgressLine(std::string doing = "rendering");
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// share: done so far, in [0, 1]. From one thread at a time.
  void show(double share);

private:
  using Clock = std::chrono::steady_clock;
  std::string doing_;
  Clock::time_point next_;
  bool on_terminal_, shown_ = false;
};

} // namespace refraster
