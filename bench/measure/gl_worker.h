#pragma once
// OpenGL's frames, drawn by a process of their own between ours.

#include "bench/measure/repetitions.h"
#include "gl/render_gl.h"

#include <span>

namespace refraster::bench {

/// A child process that holds the scene in OpenGL and draws a frame when asked. Why a process: Mesa's software drivers
/// read how many threads to use (LP_NUM_THREADS) once a screen, of which EGL has one a process; and their threads, CPU
/// time, memory and CPUs stay apart from ours.
class GlWorker {
public:
  /// Draws with this many threads, on the first so many of `cpus`. Throws NoOpenGl, whatever the reason, with it.
  GlWorker(const Scene& scene, const GlOptions& options, int threads, std::span<const int> cpus);
  ~GlWorker();
  GlWorker(const GlWorker&) = delete;
  GlWorker& operator=(const GlWorker&) = delete;

  const GlDriver& driver() const { return driver_; }

  /// Waits until our own threads are asleep, then for a frame. Throws NoOpenGl if the child has died.
  FrameTimes draw();

private:
  int child_ = -1, line_ = -1; // process; a socket to it
  GlDriver driver_;
};

} // namespace refraster::bench
