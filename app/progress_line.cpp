#include "app/progress_line.h"

#include "raster/stopwatch.h"

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <unistd.h>
#include <utility>

namespace refraster {
namespace {
using namespace std::chrono_literals;
constexpr auto patience = 1s;    // what takes less needs no line
constexpr auto interval = 100ms; // more often cannot be read
constexpr char erase_line[] = "\r\033[K";
} // namespace

ProgressLine::ProgressLine(std::string what) : what_(std::move(what)) {
  if (isatty(STDERR_FILENO) == 1) printer_ = std::jthread([this](const std::stop_token& end) { print_until(end); });
}

ProgressLine::~ProgressLine() = default; // stops the printer and waits for it

void ProgressLine::print_until(const std::stop_token& end) const {
  const Stopwatch stopwatch;
  std::mutex mutex;
  std::condition_variable_any never;
  std::unique_lock lock(mutex);
  const auto ended_within = [&](auto duration) {
    never.wait_for(lock, end, duration, [] { return false; });
    return end.stop_requested();
  };
  if (ended_within(patience)) return;
  do {
    const double fraction = fraction_.load(std::memory_order_relaxed);
    if (fraction >= 0) {
      std::fprintf(stderr, "%s%s %3.0f %%", erase_line, what_.c_str(), 100 * fraction);
      // If it goes on as it went.
      if (fraction > 0) std::fprintf(stderr, ", %.0f s left", stopwatch.seconds() * (1 - fraction) / fraction);
    } else {
      std::fprintf(stderr, "%s%s %3.0f s", erase_line, what_.c_str(), stopwatch.seconds());
    }
  } while (!ended_within(interval));
  std::fputs(erase_line, stderr);
}

std::unique_ptr<ProgressLine> progress_line(const Diagnostics& diagnostics, const std::string& what) {
  return diagnostics.verbosity == Verbosity::quiet ? nullptr : std::make_unique<ProgressLine>(what);
}

} // namespace refraster
