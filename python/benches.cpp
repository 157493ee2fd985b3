// refraster.bench

#include "bench/measure/precision_errors.h"
#include "bench/report/begun_run.h"
#include "bench/report/report_json.h"
#include "bench/workloads/built_in.h"
#include "io/file/limits.h"
#include "python/scene/scenes.h"
#include "python/work.h"
#include "raster/samples.h"

namespace refraster::python {
namespace {

using namespace refraster::bench;

struct BenchArguments {
  py::object scenes, size, precisions, threads, samples, frames, seconds;
  bool marginals, errors, allow_outside;
};

struct NamedSource {
  std::string name;
  SceneSource source;
};

NamedSource named_source(const py::object& given, std::size_t index, bool allow_outside) {
  if (py::isinstance<LiveScene>(given)) {
    const auto& live = py::cast<const LiveScene&>(given);
    return {live.path.empty() ? "scene " + std::to_string(index + 1) : live.path, source_of(live)};
  }
  NamedSource named{path_argument("scenes", given), {}};
  SceneOptions options;
  options.outside = allow_outside ? Outside::allowed : Outside::refused;
  run_watched(py::none(), [&](Watch&) { named.source = read_scene_source(named.name, options); });
  return named;
}

std::vector<NamedSource> sources_of(const BenchArguments& given) {
  std::vector<NamedSource> sources;
  if (given.scenes.is_none()) sources.push_back({built_in_name, {built_in_scene(), {}, {}}});
  else if (py::isinstance<py::list>(given.scenes) || py::isinstance<py::tuple>(given.scenes))
    for (const py::handle item : given.scenes)
      sources.push_back(named_source(py::reinterpret_borrow<py::object>(item), sources.size(), given.allow_outside));
  else sources.push_back(named_source(given.scenes, 0, given.allow_outside));
  return sources;
}

/// Those that are measured for their speed: all but `exact`.
std::vector<std::string> precisions_of(const py::object& given) {
  std::vector<std::string_view> words;
  for (const auto& [value, name] : EnumNames<Precision>::names)
    if (value != Precision::exact) words.push_back(name);
  if (given.is_none()) return {words.begin(), words.end()};
  std::vector<std::string> precisions;
  for (const std::size_t i : words_argument("precisions", given, words)) precisions.emplace_back(words[i]);
  return precisions;
}

std::vector<int> threads_of(const py::object& given) {
  std::vector<int> threads;
  const auto most = static_cast<int>(limit::threads.value);
  const auto add = [&](py::handle item) {
    threads.push_back(whole_number("threads", item, 1, most, "whole numbers from 1 to " + std::to_string(most)));
  };
  if (given.is_none()) {
    threads = {1};
    if (const auto usable = static_cast<int>(usable_cpus().size()); usable > 1) threads.push_back(usable);
  } else if (py::isinstance<py::list>(given) || py::isinstance<py::tuple>(given)) {
    for (const py::handle item : given) add(item);
  } else {
    add(given);
  }
  if (threads.empty()) refuse_argument("threads", given, "one at least");
  return threads;
}

py::object bench_scenes(const BenchArguments& given, const py::object& progress) {
  SceneTask task;
  std::tie(task.width, task.height) = size_argument("size", given.size);
  task.precisions = precisions_of(given.precisions);
  task.threads = threads_of(given.threads);
  task.samples = whole_number("samples", given.samples, 1, 16, expected_value(SampleCount{task.samples}, Range{}));
  if (!is_sample_count(task.samples))
    refuse_argument("samples", given.samples, expected_value(SampleCount{task.samples}, Range{}));
  task.marginals = given.marginals ? Marginals::measured : Marginals::left_out;
  Repetitions repetitions;
  read_argument("frames", given.frames, Range{1, 1000000}, repetitions.least);
  read_argument("seconds", given.seconds, Range{0, 86400}, repetitions.seconds);
  std::vector<NamedSource> sources = sources_of(given);
  Run run = begun_run("refraster.bench", repetitions, task.threads);
  for (NamedSource& named : sources)
    run_watched(progress, [&](Watch& watch) {
      repetitions.stop = &watch.stop;
      repetitions.progress = [&watch](double done) { watch.fraction = done; };
      const PinnedThreadPool thread_pool;
      task.name = named.name;
      task.scene = std::move(named.source).placed(task.width, task.height);
      SceneResult result = bench_scene(task, repetitions, thread_pool);
      if (watch.stop) return;
      if (given.errors) result.errors = precision_errors(task, static_cast<int>(run.machine.usable_cpus.size()));
      add_scene(run, task, std::move(result));
    });
  end_run(run);
  return dictionary(run_json(run));
}

} // namespace

void bind_bench(py::module_& module) {
  const py::object none = py::none();
  module.def(
      "bench",
      [](const py::object& scenes, const py::object& size, const py::object& precisions, const py::object& threads,
         const py::object& samples, const py::object& frames, const py::object& seconds, bool marginals, bool errors,
         bool allow_outside, const py::object& progress) {
        return bench_scenes(
            {scenes, size, precisions, threads, samples, frames, seconds, marginals, errors, allow_outside}, progress);
      },
      py::arg("scenes") = none, py::kw_only(), py::arg("size") = py::make_tuple(1280, 720),
      py::arg("precisions") = none, py::arg("threads") = none, py::arg("samples") = 1, py::arg("frames") = 9,
      py::arg("seconds") = 3.0, py::arg("marginals") = true, py::arg("errors") = true, py::arg("allow_outside") = false,
      py::arg("progress") = none,
      "What a pixel costs, and what accuracy it buys: the dictionary of `refraster bench --json`, docs/reports.md, "
      "without "
      "OpenGL and without whole commands.\n\nscenes: a Scene or a path, or a list of them; by default a sphere that "
      "fills "
      "the image. precisions: \"double\", \"float\", \"fast\"; by default all. threads: numbers of threads; by default "
      "1 "
      "and all CPUs. frames, seconds: repetitions at least, and more until so many seconds have passed, for each "
      "scene. "
      "progress: called with the fraction done of each scene.");
}

} // namespace refraster::python
