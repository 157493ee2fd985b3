#include "gl/context/frame_timer.h"

#include "raster/stopwatch.h"

namespace refraster {

GlTimes time_frames(int count, const std::function<void()>& frame) {
  GlTimes times;
  for (int i = 0; i < count; ++i) {
    const Stopwatch wall, cpu(TimeOf::process);
    frame();
    times.cpu_ms.push_back(cpu.milliseconds());
    times.wall_ms.push_back(wall.milliseconds());
  }
  return times;
}

} // namespace refraster
