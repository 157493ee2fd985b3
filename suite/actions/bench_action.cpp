// How long a frame takes, measured as `refraster bench` does.

#include "bench/measure/frame_source.h"
#include "bench/measure/repetitions.h"
#include "bench/measure/statistics.h"
#include "io/file/text.h"
#include "raster/stopwatch.h"
#include "suite/actions/actions.h"
#include "suite/actions/thumbnail.h"

#include <algorithm>

namespace refraster::suite {

void time_frame(Task& task) {
  EntryResult& result = task.result;
  const RenderOptions options = task.placed_options();
  bench::FrameSource frames;
  const bench::Candidate candidate = [&]() -> bench::FrameTimes {
    const Stopwatch wall, cpu(TimeOf::process);
    const Frame& frame = frames.draw(task.source.scene, options);
    return {wall.milliseconds(), cpu.milliseconds(), frame.seconds, frame.tile_seconds};
  };
  bench::Repetitions repetitions;
  repetitions.seconds = 0; // as few as have quartiles: many entries are to be timed
  const std::vector<std::vector<bench::FrameTimes>> times = bench::interleaved({&candidate, 1}, repetitions);
  std::vector<double> walls;
  for (const bench::FrameTimes& one : times.front()) walls.push_back(one.wall_ms);
  const bench::Spread spread = bench::spread_of(walls);
  result.frame_ms = spread.median;
  result.width = options.width, result.height = options.height;
  result.message = format("%.3g ms a frame, quartiles %.3g and %.3g", spread.median, spread.lower, spread.upper);
  result.thumbnail = thumbnail_of(frames.draw(task.source.scene, options).rgb8);
  const std::optional<double> most = task.entry.limits.frame_ms;
  result.state = most && spread.median > *most ? State::different : State::done;
  if (result.state != State::different) return;
  result.message += format(", expected at most %g ms", *most);
  result.severity = std::min(1.0, 1 - *most / spread.median);
}

} // namespace refraster::suite
