#include "bench/report/begun_run.h"

#include "bench/report/doubts.h"
#include "raster/explain/explain_dark.h"

#include <utility>

namespace refraster::bench {

Run begun_run(const std::string& command, const Repetitions& repetitions, std::span<const int> threads) {
  Run run;
  run.command = command;
  run.started = utc_now();
  run.machine = this_machine();
  run.load_at_start = load_average();
  run.warm_up = repetitions.warm_up;
  run.min_repetitions = repetitions.least;
  run.seconds = repetitions.seconds;
  const auto usable = static_cast<int>(run.machine.usable_cpus.size());
  for (const int count : threads)
    if (count > usable)
      run.notes.push_back(std::to_string(count) + " threads share " + std::to_string(usable) + " CPUs");
  return run;
}

void add_scene(Run& run, const SceneTask& task, SceneResult result) {
  if (result.counts.shaded == 0) {
    RenderOptions options;
    options.width = task.width, options.height = task.height;
    run.notes.push_back(task.name + ": " + explain_no_surface(task.scene, options) +
                        "; nothing is known of a shaded pixel");
  }
  run.scenes.push_back(std::move(result));
}

void end_run(Run& run) {
  run.ended = utc_now();
  run.load_at_end = load_average();
  for (std::string& note : doubts(run)) run.notes.push_back(std::move(note));
}

} // namespace refraster::bench
