#include "bench/measure/scene_bench.h"

#include "bench/measure/frame_source.h"
#include "bench/measure/gl_worker.h"
#include "raster/processor_time.h"
#include "raster/samples.h"

#include <algorithm>
#include <deque>

namespace refraster::bench {
namespace {

using Frames = std::vector<FrameTimes>; // by repetition

/// What is drawn in turn, by number. Scenes and memory of frames stay where they are while they are in use.
class Candidates {
public:
  Candidates(const SceneTask& task, const PinnedThreadPool& thread_pool) : task_(task), thread_pool_(thread_pool) {}

  std::size_t add(const Scene& scene, const std::string& precision, int threads, int samples, FrameSource& source) {
    RenderOptions options;
    options.width = task_.width, options.height = task_.height;
    options.precision = value_named<Precision>(precision).value();
    options.samples = samples;
    options.threads = threads;
    FrameCounts& counts = counts_.emplace_back();
    candidates_.push_back([this, &scene, options, &source, &counts] {
      thread_pool_.pin(options.threads);
      const Stopwatch wall;
      const ProcessorTime cpu;
      const Frame& frame = source.draw(scene, options);
      const FrameTimes times{wall.milliseconds(), cpu.milliseconds(), frame.seconds, frame.tile_seconds};
      counts = frame.counts;
      return times;
    });
    return candidates_.size() - 1;
  }

  std::size_t add(GlWorker& worker) {
    counts_.emplace_back();
    candidates_.push_back([&worker] { return worker.draw(); });
    return candidates_.size() - 1;
  }

  const Scene& store(Scene scene) { return scenes_.emplace_back(std::move(scene)); }
  FrameSource& source() { return sources_.emplace_back(); }

  void run(const Repetitions& repetitions) { times_ = interleaved(candidates_, repetitions); }
  const Frames& of(std::size_t i) const { return times_[i]; }
  const FrameCounts& counts(std::size_t i) const { return counts_[i]; }

private:
  const SceneTask& task_;
  const PinnedThreadPool& thread_pool_;
  std::deque<Scene> scenes_;
  std::deque<FrameSource> sources_;
  std::deque<FrameCounts> counts_;
  std::vector<Candidate> candidates_;
  std::vector<Frames> times_;
};

Spread spread(const Frames& frames, double FrameTimes::*time) {
  std::vector<double> values;
  for (const FrameTimes& one : frames) values.push_back(one.*time);
  return spread_of(std::move(values));
}

/// Of what happened in the same repetition: changes of the machine's speed from repetition to repetition take no part.
template <class Value>
Spread paired_difference(const Frames& changed, const Frames& base, const Value& value) {
  std::vector<double> differences;
  for (std::size_t r = 0; r < base.size(); ++r) differences.push_back(value(changed[r]) - value(base[r]));
  return spread_of(std::move(differences));
}

double wall(const FrameTimes& times) {
  return times.wall_ms;
}
double cpu(const FrameTimes& times) {
  return times.cpu_ms;
}
double thread_shading(const FrameTimes& times) {
  return times.tiles.shading;
}

/// In ms of wall time. The tiles' stages are known in thread seconds: they share the tiles' wall time in proportion.
/// Interpolation and lighting are one stage, told apart by frames without lights.
Split split_ms(const Frames& lit, const Frames& unlit) {
  std::vector<double> walls;
  const auto mean = [&](const Frames& frames, const auto& value) {
    walls.clear();
    for (const FrameTimes& one : frames) walls.push_back(one.wall_ms);
    double sum = 0;
    const std::vector<std::size_t> kept = middle_half(walls);
    for (const std::size_t i : kept) sum += value(frames[i]);
    return sum / static_cast<double>(kept.size());
  };
  const auto of_tiles = [&](const Frames& frames, double TileSeconds::*part) {
    return mean(frames, [&](const FrameTimes& t) {
      const double sum = t.tiles.sum();
      return sum > 0 ? 1e3 * t.stages.tiles * t.tiles.*part / sum : 0;
    });
  };
  Split split;
  split.transform = mean(lit, [](const FrameTimes& t) { return 1e3 * t.stages.transform; });
  split.bin = mean(lit, [](const FrameTimes& t) { return 1e3 * t.stages.bin; });
  split.visibility = of_tiles(lit, &TileSeconds::visibility);
  split.attribute_setup = of_tiles(lit, &TileSeconds::attribute_setup);
  split.interpolation = of_tiles(unlit, &TileSeconds::shading);
  split.lighting = of_tiles(lit, &TileSeconds::shading) - split.interpolation;
  split.resolve = of_tiles(lit, &TileSeconds::resolve);
  double known = 0;
  for (const auto& [name, part] : split_parts) known += split.*part;
  split.other = mean(lit, wall) - known;
  return split;
}

/// What the tiles' wall time has of shading, in ms.
double wall_shading_ms(const FrameTimes& times) {
  const double sum = times.tiles.sum();
  return sum > 0 ? 1e3 * times.stages.tiles * times.tiles.shading / sum : 0;
}

/// The numbers of the frames that one precision's figures come from.
struct PrecisionFrames {
  struct Ways {
    int threads;
    std::size_t lit, unlit;
  };
  std::vector<Ways> ways; // by number of threads
  // With the first number of threads.
  struct OfFunction {
    FragmentFunctionVariant function;
    std::size_t lit, unlit;
  };
  std::vector<OfFunction> functions;
  std::optional<std::size_t> light, other_texture, double_samples;
};

PrecisionFrames plan(const SceneTask& task, const std::string& precision, Candidates& candidates) {
  PrecisionFrames frames;
  const Scene& lit = task.scene;
  const Scene& unlit = candidates.store(without_lights(lit));
  FrameSource& other_source = candidates.source();
  for (const int threads : task.threads)
    frames.ways.push_back({threads, candidates.add(lit, precision, threads, task.samples, candidates.source()),
                           candidates.add(unlit, precision, threads, task.samples, other_source)});
  if (task.marginals == Marginals::left_out) return frames;

  const auto add = [&](Scene scene, int samples) {
    return candidates.add(candidates.store(std::move(scene)), precision, task.threads.front(), samples, other_source);
  };
  frames.light = add(with_one_more_light(lit), task.samples);
  if (has_textures(lit)) frames.other_texture = add(without_textures(lit), task.samples);
  else if (shows_textures(lit)) frames.other_texture = add(with_textures(lit), task.samples);
  if (is_sample_count(2 * task.samples)) frames.double_samples = add(lit, 2 * task.samples);

  const std::vector<FragmentFunctionVariant> functions = functions_of(lit);
  if (lights(lit) == 0) return frames;
  if (functions.size() == 1) { // no one else's objects to be left out
    frames.functions.push_back({functions[0], frames.ways[0].lit, frames.ways[0].unlit});
    return frames;
  }
  for (const FragmentFunctionVariant& function : functions) {
    const Scene part = only(lit, function);
    const std::size_t of_part = add(part, task.samples);
    const auto known = std::find_if(frames.functions.begin(), frames.functions.end(),
                                    [&](const auto& one) { return one.function.name == function.name; });
    const std::size_t unlit_part =
        known != frames.functions.end() ? known->unlit : add(without_lights(part), task.samples);
    frames.functions.push_back({function, of_part, unlit_part});
  }
  return frames;
}

Marginal marginal_of(const PrecisionFrames& frames, const Candidates& candidates, const SceneTask& task,
                     double shaded) {
  const double ns_per_pixel = 1e6 / shaded;
  const Frames& base = candidates.of(frames.ways.front().lit);
  const auto added = [&](std::size_t i) { return paired_difference(candidates.of(i), base, cpu) * ns_per_pixel; };
  Marginal marginal;
  marginal.light = added(*frames.light);
  if (frames.double_samples) marginal.double_samples = added(*frames.double_samples);
  if (!frames.other_texture) return marginal;
  if (has_textures(task.scene)) {
    marginal.texture_change = TextureChange::removed;
    marginal.texture = paired_difference(base, candidates.of(*frames.other_texture), cpu) * ns_per_pixel;
  } else {
    marginal.texture = added(*frames.other_texture);
  }
  return marginal;
}

std::vector<FunctionCost> function_costs(const PrecisionFrames& frames, const Candidates& candidates,
                                         std::size_t lights) {
  std::vector<FunctionCost> costs;
  for (const auto& [function, lit, unlit] : frames.functions) {
    const std::uint64_t fragments = candidates.counts(lit).fragments;
    if (fragments == 0) continue;
    const double ns = 1e9 / (static_cast<double>(fragments) * static_cast<double>(lights));
    costs.push_back(
        {function, fragments, paired_difference(candidates.of(lit), candidates.of(unlit), thread_shading) * ns});
  }
  return costs;
}

/// OpenGL with one number of threads.
struct GlFrames {
  std::unique_ptr<GlWorker> worker;
  std::size_t frames;
};
std::vector<GlFrames> plan_opengl(const SceneTask& task, const PinnedThreadPool& thread_pool, Candidates& candidates) {
  std::vector<GlFrames> planned;
  if (!task.opengl) return planned;
  GlOptions options;
  options.width = task.width, options.height = task.height;
  options.renderer = *task.opengl;
  for (const int threads : task.threads) {
    auto worker = std::make_unique<GlWorker>(task.scene, options, threads, thread_pool.cpus());
    const std::size_t frames = candidates.add(*worker);
    planned.push_back({std::move(worker), frames});
  }
  return planned;
}

/// a / b, repetition by repetition.
Spread paired_ratio(const Frames& a, const Frames& b) {
  std::vector<double> ratios;
  for (std::size_t r = 0; r < a.size(); ++r) ratios.push_back(a[r].wall_ms / b[r].wall_ms);
  return spread_of(std::move(ratios));
}

} // namespace

SceneResult bench_scene(const SceneTask& task, const Repetitions& repetitions, const PinnedThreadPool& thread_pool) {
  Candidates candidates(task, thread_pool);
  const std::vector<GlFrames> opengl = plan_opengl(task, thread_pool, candidates);
  std::vector<PrecisionFrames> planned;
  for (const std::string& precision : task.precisions) planned.push_back(plan(task, precision, candidates));
  candidates.run(repetitions);

  SceneResult result;
  result.scene = task.name;
  result.width = task.width, result.height = task.height, result.samples = task.samples;
  result.lights = lights(task.scene);
  if (repetitions.stop && repetitions.stop->load()) return result;
  result.counts = candidates.counts(planned.front().ways.front().lit);
  result.repetitions = candidates.of(0).size();
  for (std::size_t way = 0; way < opengl.size(); ++way) {
    const GlDriver& driver = opengl[way].worker->driver();
    const Frames& frames = candidates.of(opengl[way].frames);
    result.opengl.push_back({task.threads[way], driver.renderer, driver.version, spread(frames, &FrameTimes::wall_ms),
                             spread(frames, &FrameTimes::cpu_ms)});
  }
  for (std::size_t i = 0; i < task.precisions.size(); ++i) {
    const PrecisionFrames& frames = planned[i];
    for (std::size_t way = 0; way < frames.ways.size(); ++way) {
      const auto& [threads, lit, unlit] = frames.ways[way];
      PrecisionResult& precision = result.precisions.emplace_back();
      precision.precision = task.precisions[i];
      precision.threads = threads;
      if (!opengl.empty()) precision.opengl_ratio = paired_ratio(candidates.of(opengl[way].frames), candidates.of(lit));
      precision.frame_ms = spread(candidates.of(lit), &FrameTimes::wall_ms);
      precision.cpu_ms = spread(candidates.of(lit), &FrameTimes::cpu_ms);
      precision.split_ns = split_ms(candidates.of(lit), candidates.of(unlit));
      for (const auto& [name, part] : split_parts) precision.split_ns.*part *= 1e6 / result.shaded();
      precision.lighting_ns =
          paired_difference(candidates.of(lit), candidates.of(unlit), wall_shading_ms) * (1e6 / result.shaded());
      if (way > 0 || !frames.light) continue;
      precision.marginal = marginal_of(frames, candidates, task, result.shaded());
      precision.functions = function_costs(frames, candidates, result.lights);
    }
  }
  return result;
}

} // namespace refraster::bench
