#pragma once
// How cost grows.

#include "bench/machine/cpus.h"
#include "bench/measure/repetitions.h"
#include "bench/measure/statistics.h"
#include "bench/workloads/scaling_scenes.h"

#include <optional>

namespace refraster::bench {

struct ScalingTask {
  Growth growth = Growth::triangles;
  double most = 0;
  LayerOrder order = LayerOrder::back_to_front; // of overdraw
  ImageSize size;
  int threads = 1;
  std::vector<std::string> precisions;
};

/// What one point of a curve came to.
struct MeasuredPoint {
  ScalingPoint point;
  Spread frame_ms, cpu_ms;
  std::size_t frames = 0;
  std::optional<std::uint64_t> peak_memory_bytes; // resident, with the scene and all else
  FrameCounts counts;
};

/// One precision's.
struct ScalingCurve {
  Growth growth = Growth::triangles;
  LayerOrder order = LayerOrder::back_to_front;
  std::string precision;
  std::vector<MeasuredPoint> points;

  /// Of the upper half of the points, three at least, where what grows outweighs what does not: a straight line in
  /// logarithms. Nothing with less than two points.
  std::optional<Slope> slope() const;
  /// The greatest slope between neighbours, and where it begins.
  struct Steepest {
    double slope, from;
  };
  std::optional<Steepest> steepest() const;
  /// Whether cost grows no faster than linearly: the slope is not above 1 by more than twice its standard error.
  /// Nothing for threads, and with less than three points.
  std::optional<bool> no_faster_than_linear() const;
  /// Whether the same number of fragments was shaded at each point.
  bool same_fragments() const;
};

/// Curves of all precisions, their frames in turn; `repetitions.least` of them at each point, but no more than three
/// once a point has taken `repetitions.seconds`. Each frame is the second one that its memory sees.
std::vector<ScalingCurve> measure_scaling(const ScalingTask& task, const Repetitions& repetitions,
                                          const PinnedThreadPool& thread_pool);

} // namespace refraster::bench
