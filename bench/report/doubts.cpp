#include "bench/report/doubts.h"

#include "io/file/text.h"

#include <algorithm>

namespace refraster::bench {
namespace {

int max_threads(const Run& run) {
  int most = 0;
  for (const SceneResult& scene : run.scenes)
    for (const PrecisionResult& precision : scene.precisions) most = std::max(most, precision.threads);
  for (const ScalingCurve& curve : run.scaling)
    for (const MeasuredPoint& one : curve.points) most = std::max(most, one.point.threads);
  return most;
}

/// `others`: how many threads of other programs wanted to run. A load average is a mean, and half a thread of what the
/// system itself does is always there.
void add_load(std::vector<std::string>& notes, const Run& run, const char* when, double others) {
  const int threads = std::min(max_threads(run), run.machine.cpus);
  constexpr double always = 0.5;
  if (threads > 0 && others + threads > run.machine.cpus + always)
    notes.push_back(
        format("%s other programs kept %.1f of %d CPUs busy, by the load average, and up to %d were measured "
               "on: figures may be too high",
               when, others, run.machine.cpus, threads));
}

/// A time that was measured, and what it is of.
struct Timed {
  std::string what;
  const Spread& time;
  std::size_t repetitions;
};

std::vector<Timed> all_times(const Run& run) {
  std::vector<Timed> times;
  const auto threads_text = [](int threads) { return format("%d thread%s", threads, threads == 1 ? "" : "s"); };
  for (const SceneResult& scene : run.scenes) {
    const auto add = [&](const std::string& who, int threads, const Spread& time) {
      times.push_back(
          {who + " with " + threads_text(threads) + " on " + scene.scene + format(", %dx%d", scene.width, scene.height),
           time, scene.repetitions});
    };
    for (const PrecisionResult& precision : scene.precisions)
      add(precision.precision, precision.threads, precision.frame_ms);
    for (const OpenGlResult& one : scene.opengl) add("OpenGL", one.threads, one.frame_ms);
  }
  for (const ScalingCurve& curve : run.scaling)
    for (const MeasuredPoint& one : curve.points)
      times.push_back({curve.precision + " at " + with_commas(static_cast<unsigned long long>(one.point.n)) + " " +
                           std::string(name_of(curve.growth)),
                       one.frame_ms, one.frames});
  return times;
}

void add_scatter(std::vector<std::string>& notes, const Run& run) {
  constexpr double max_error = 0.05; // two digits: from 1.05 to 1.1
  const std::vector<Timed> times = all_times(run);
  const Timed* worst = nullptr;
  std::size_t scattered = 0, unknown = 0;
  for (const Timed& one : times) {
    const double error = median_error(one.time, one.repetitions);
    unknown += one.repetitions < 3;
    if (!(error > max_error)) continue;
    ++scattered;
    if (!worst || error > median_error(worst->time, worst->repetitions)) worst = &one;
  }
  if (worst)
    notes.push_back(format("%zu of %zu frame times scatter so much that their second digit means nothing; most of all ",
                           scattered, times.size()) +
                    worst->what +
                    format(", whose quartiles are %.0f %% of the median apart, over %zu repetitions",
                           100 * quartile_distance(worst->time) / worst->time.median, worst->repetitions));
  if (unknown > 0)
    notes.push_back(
        format("%zu of %zu frame times are of fewer than three repetitions: how far they scatter is not known", unknown,
               times.size()));
}

} // namespace

std::vector<std::string> doubts(const Run& run) {
  std::vector<std::string> notes;
  add_load(notes, run, "at the start", run.load_at_start[0]);
  // At the end, our own threads are in it.
  add_load(notes, run, "at the end", std::max(0.0, run.load_at_end[0] - max_threads(run)));
  add_scatter(notes, run);
  return notes;
}

} // namespace refraster::bench
