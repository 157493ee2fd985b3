#pragma once
// A run, from its first line to its last: when, where, and what to think of it.

#include "bench/measure/repetitions.h"
#include "bench/measure/results.h"
#include "bench/measure/scene_bench.h"

#include <span>
#include <string>

namespace refraster::bench {

/// Begun now, on this machine, by this command, to measure with so many threads.
Run begun_run(const std::string& command, const Repetitions& repetitions, std::span<const int> threads);

/// Adds what was measured of a scene, and, where that is nothing, a note why.
void add_scene(Run& run, const SceneTask& task, SceneResult result);

/// Ended now; notes what makes its figures worth little.
void end_run(Run& run);

} // namespace refraster::bench
