#pragma once
// Frames of several kinds, timed in turn.

#include <refraster/render.h>

#include <atomic>
#include <functional>
#include <span>
#include <vector>

namespace refraster::bench {

/// One frame. `cpu_ms` is that of all threads that drew it; stages are those that refraster knows of.
struct FrameTimes {
  double wall_ms = 0, cpu_ms = 0;
  StageSeconds stages;
  TileSeconds tiles;
};

/// Draws one frame.
using Candidate = std::function<FrameTimes()>;

struct Repetitions {
  int warm_up = 1;    // not counted: first touches of memory, drivers that compile on the first draw
  int least = 9;      // repetitions, however long they take
  double seconds = 3; // and as many more as end within this time
  const std::atomic<bool>* stop = nullptr;   // when it becomes true, no further frame is begun
  std::function<void(double)> progress = {}; // called with the fraction done, in [0, 1]
};

/// In each repetition every candidate draws one frame, so that whatever slows the machine down for a while slows all of
/// them down alike; in an order that differs from repetition to repetition, so that nobody always follows the same
/// neighbour. Returns for each candidate its frames, by repetition. With `stop`, the repetitions that all have
/// finished.
std::vector<std::vector<FrameTimes>> interleaved(std::span<const Candidate> candidates, const Repetitions& repetitions);

} // namespace refraster::bench
