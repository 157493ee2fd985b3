#pragma once
// One scene, timed in all the ways that were asked for.

#include "bench/machine/cpus.h"
#include "bench/measure/repetitions.h"
#include "bench/measure/results.h"
#include "gl/gl_names.h"

namespace refraster::bench {

/// Whether the variants of a scene that tell marginal costs are drawn too.
enum class Marginals { measured, left_out };

struct SceneTask {
  std::string name; // for the reader
  Scene scene;
  int width = 1280, height = 720, samples = 1;
  std::vector<std::string> precisions;
  std::vector<int> threads; // at least one
  Marginals marginals = Marginals::measured;
  std::optional<GlRenderer> opengl = {}; // draws too; with one sample a pixel
};

/// Timings only; PrecisionError comes from elsewhere. Throws NoOpenGl, before any frame of ours. After
/// `repetitions.stop` became true, what it returns is worthless.
SceneResult bench_scene(const SceneTask& task, const Repetitions& repetitions, const PinnedThreadPool& thread_pool);

} // namespace refraster::bench
