#include "app/progress_line.h"

#include <cstdio>
#include <unistd.h>
#include <utility>

namespace refraster {
namespace {
using namespace std::chrono_literals;
constexpr auto patience = 1s;    // what takes less needs no line
constexpr auto interval = 100ms; // more often cannot be read
constexpr char erase_line[] = "\r\033[K";
} // namespace

ProgressLine::ProgressLine(std::string doing)
    : doing_(std::move(doing)), next_(Clock::now() + patience), on_terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (shown_) std::fputs(erase_line, stderr);
}

void ProgressLine::show(double share) {
  if (!on_terminal_) return;
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + interval;
  shown_ = true;
  std::fprintf(stderr, "%s%s %3.0f %%", erase_line, doing_.c_str(), 100 * share);
}

} // namespace refraster
