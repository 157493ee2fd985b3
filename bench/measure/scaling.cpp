#include "bench/measure/scaling.h"

#include "bench/machine/memory.h"
#include "bench/measure/frame_source.h"
#include "raster/processor_time.h"

#include <algorithm>
#include <cmath>

namespace refraster::bench {
namespace {

std::vector<Point> in_plane(const ScalingCurve& curve) {
  std::vector<Point> points;
  for (const MeasuredPoint& one : curve.points) points.push_back({one.point.n, one.frame_ms.median});
  return points;
}

/// The measurements of one precision at one point, as they come in.
struct Collected {
  std::vector<double> wall_ms, cpu_ms;
  std::uint64_t peak_memory_bytes = 0;
  bool memory_known = true;
  FrameCounts counts;
};

void measure_once(const Scene& scene, const RenderOptions& options, const PinnedThreadPool& thread_pool,
                  Collected& collected) {
  thread_pool.pin(options.threads);
  restart_peak_memory();
  FrameSource source;
  source.draw(scene, options);
  const Stopwatch wall;
  const ProcessorTime cpu;
  const Frame& frame = source.draw(scene, options);
  collected.cpu_ms.push_back(cpu.milliseconds());
  collected.wall_ms.push_back(wall.milliseconds());
  collected.counts = frame.counts;
  const std::optional<std::uint64_t> peak = peak_memory_bytes();
  collected.memory_known = collected.memory_known && peak;
  collected.peak_memory_bytes = std::max(collected.peak_memory_bytes, peak.value_or(0));
}

} // namespace

std::optional<Slope> ScalingCurve::slope() const {
  if (points.size() < 2) return std::nullopt;
  const std::vector<Point> all = in_plane(*this);
  const std::size_t upper = std::min(all.size(), std::max<std::size_t>(3, (all.size() + 1) / 2));
  return log_log_slope(std::span(all).last(upper));
}

std::optional<ScalingCurve::Steepest> ScalingCurve::steepest() const {
  const std::vector<Point> all = in_plane(*this);
  std::optional<Steepest> found;
  for (std::size_t i = 1; i < all.size(); ++i) {
    const double slope = log_log_slope(std::span(all).subspan(i - 1, 2)).value;
    if (!found || slope > found->slope) found = {slope, all[i - 1].x};
  }
  return found;
}

std::optional<bool> ScalingCurve::no_faster_than_linear() const {
  if (growth == Growth::threads || points.size() < 3) return std::nullopt;
  const Slope found = *slope();
  return found.value - 2 * found.error <= 1;
}

bool ScalingCurve::same_fragments() const {
  return std::all_of(points.begin(), points.end(), [&](const MeasuredPoint& point) {
    return point.counts.fragments == points.front().counts.fragments;
  });
}

std::vector<ScalingCurve> measure_scaling(const ScalingTask& task, const Repetitions& repetitions,
                                          const PinnedThreadPool& thread_pool) {
  std::vector<ScalingPoint> points =
      scaling_points(task.growth, task.most, task.size, task.threads, static_cast<int>(thread_pool.cpus().size()));
  for (ScalingPoint& point : points) point.order = task.order;
  std::vector<std::vector<Collected>> collected(points.size(), std::vector<Collected>(task.precisions.size()));
  std::vector<double> spent_ms(points.size(), 0);
  const auto stopped = [&] { return repetitions.stop && repetitions.stop->load(); };

  for (int repetition = 0; repetition < repetitions.least && !stopped(); ++repetition)
    for (std::size_t step = 0; step < points.size() && !stopped(); ++step) {
      // Up and down in turn, so that a machine that gets slower does not look like a curve that gets steeper.
      const std::size_t i = repetition % 2 == 0 ? step : points.size() - 1 - step;
      if (repetition >= 3 && spent_ms[i] > 1e3 * repetitions.seconds) continue;
      const Stopwatch stopwatch;
      const Scene scene = scaling_scene(task.growth, points[i]);
      RenderOptions options;
      options.width = points[i].width, options.height = points[i].height;
      options.threads = points[i].threads;
      for (std::size_t precision = 0; precision < task.precisions.size() && !stopped(); ++precision) {
        options.precision = value_named<Precision>(task.precisions[precision]).value();
        measure_once(scene, options, thread_pool, collected[i][precision]);
      }
      spent_ms[i] += stopwatch.milliseconds();
      if (repetitions.progress)
        repetitions.progress((repetition + static_cast<double>(step) / static_cast<double>(points.size())) /
                             repetitions.least);
    }

  std::vector<ScalingCurve> curves;
  if (stopped()) return curves;
  for (std::size_t precision = 0; precision < task.precisions.size(); ++precision) {
    ScalingCurve& curve = curves.emplace_back();
    curve.growth = task.growth, curve.order = task.order, curve.precision = task.precisions[precision];
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Collected& found = collected[i][precision];
      MeasuredPoint& point = curve.points.emplace_back();
      point.point = points[i];
      point.frames = found.wall_ms.size();
      point.frame_ms = spread_of(found.wall_ms);
      point.cpu_ms = spread_of(found.cpu_ms);
      if (found.memory_known) point.peak_memory_bytes = found.peak_memory_bytes;
      point.counts = found.counts;
    }
  }
  return curves;
}

} // namespace refraster::bench
