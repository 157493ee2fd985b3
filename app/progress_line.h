#pragma once
// How far something long is.

#include "app/diagnostics.h"

#include <atomic>
#include <memory>
#include <string>
#include <thread>

namespace refraster {

/// While it lives, and from the second second on: a line on stderr that says what is being done and for how long, or
/// how far it is and how long the rest may take, if stderr is a terminal. Wiped at the end.
class ProgressLine {
public:
  /// what: "reading ball.json".
  explicit ProgressLine(std::string what);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// fraction: done so far, in [0, 1]. From any thread.
  void show(double fraction) { fraction_.store(fraction, std::memory_order_relaxed); }

private:
  void print_until(const std::stop_token& end) const;

  std::string what_;
  std::atomic<double> fraction_{-1}; // nobody has said
  std::jthread printer_;             // none off a terminal
};

/// A line for what is not to be quiet; else nothing.
std::unique_ptr<ProgressLine> progress_line(const Diagnostics& diagnostics, const std::string& what);

} // namespace refraster
