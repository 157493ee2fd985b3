#include "gl/context/frame_timer.h"

#include <ctime>

namespace refraster {
namespace {

double milliseconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

} // namespace

GlTimes time_frames(int count, const std::function<void()>& frame) {
  GlTimes times;
  for (int i = 0; i < count; ++i) {
    const double wall = milliseconds(CLOCK_MONOTONIC), cpu = milliseconds(CLOCK_PROCESS_CPUTIME_ID);
    frame();
    times.cpu_ms.push_back(milliseconds(CLOCK_PROCESS_CPUTIME_ID) - cpu);
    times.wall_ms.push_back(milliseconds(CLOCK_MONOTONIC) - wall);
  }
  return times;
}

} // namespace refraster
