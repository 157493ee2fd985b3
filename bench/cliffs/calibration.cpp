#include "bench/cliffs/calibration.h"

#include "bench/cliffs/shapes.h"
#include "bench/measure/repetitions.h"
#include "bench/measure/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace refraster::cliffs {
namespace {

/// A frame's time, again and again.
bench::Candidate frames_of(const Work& work, Frame& frame, Renderer& renderer) {
  return [&] {
    renderer.render(work.scene, work.options, frame);
    bench::FrameTimes times;
    times.wall_ms = 1e3 * frame.seconds.total;
    return times;
  };
}

Timing timing_of(const std::vector<bench::FrameTimes>& times, const FrameCounts& counts) {
  std::vector<double> ms;
  for (const bench::FrameTimes& time : times) ms.push_back(time.wall_ms);
  const bench::Spread spread = bench::spread_of(ms);
  return {spread.lower, spread.median, spread.upper, counts};
}

/// What the second costs beyond the first, for each of `units`.
double difference(const Work& less, const Work& more, double units) {
  const TwoTimings timings = timings_of(less, more, 1);
  return std::max(1e6 * (timings.second.median_ms - timings.first.median_ms) / units, 0.0);
}

} // namespace

Load load_of(const Work& work, const FrameCounts& counts) {
  Load load;
  load.pixels = static_cast<double>(counts.pixels) * work.options.samples;
  load.covered = load.pixels * work.layers;
  load.fragments = static_cast<double>(counts.fragments * std::max<std::size_t>(light_count(work.scene), 1));
  for (const Object& object : work.scene.objects) {
    load.triangles += static_cast<double>(object.mesh->triangles.size());
    load.vertices += static_cast<double>(object.mesh->positions.size());
  }
  return load;
}

double ordinary_ms(const OrdinaryCost& cost, const Load& load) {
  return 1e-6 * (cost.pixel * load.pixels + cost.covered * load.covered + cost.fragment * load.fragments +
                 cost.triangle * load.triangles + cost.vertex * load.vertices);
}

TwoTimings timings_of(const Work& first, const Work& second, double seconds) {
  std::array<Frame, 2> frames;
  std::array<Renderer, 2> renderers;
  const bench::Candidate candidates[] = {frames_of(first, frames[0], renderers[0]),
                                         frames_of(second, frames[1], renderers[1])};
  bench::Repetitions repetitions;
  repetitions.least = 5, repetitions.seconds = seconds;
  const auto times = bench::interleaved(candidates, repetitions);
  return {timing_of(times[0], frames[0].counts), timing_of(times[1], frames[1].counts)};
}

OrdinaryCost measured_costs(Precision precision) {
  const auto work_of = [&](std::string_view name, std::span<const Family> families, double size) {
    const auto family = std::find_if(families.begin(), families.end(), [&](const Family& f) { return f.name == name; });
    Work work = family->make(size);
    work.options.precision = precision;
    return work;
  };
  constexpr double image = 1 << 20;
  const Work empty = work_of("nothing but the background", pixel_families(), image);
  const Work small = work_of("nothing but the background", pixel_families(), image / 16);
  const Work filled = work_of("a wall of few triangles", pixel_families(), image);
  const Work layers_1 = work_of("triangles over the whole image, back to front", geometry_families(), 1);
  const Work layers_65 = work_of("triangles over the whole image, back to front", geometry_families(), 65);
  const Work few_vertices = work_of("vertices that no triangle has", geometry_families(), 1e4);
  const Work many_vertices = work_of("vertices that no triangle has", geometry_families(), 1e6);
  const Work few_triangles = work_of("a wall of more and more triangles", geometry_families(), 200);
  const Work many_triangles = work_of("a wall of more and more triangles", geometry_families(), 262'144);

  OrdinaryCost cost;
  cost.pixel = difference(small, empty, image - image / 16);
  cost.covered = difference(layers_1, layers_65, 64.0 * 512 * 512);
  cost.fragment = std::max(difference(empty, filled, image) - cost.covered, 0.0);
  cost.vertex = difference(few_vertices, many_vertices, 1e6 - 1e4);
  cost.triangle = std::max(difference(few_triangles, many_triangles, 262'144 - 200) - cost.vertex / 2, 0.0);
  return cost;
}

} // namespace refraster::cliffs
