#include "bench/report/report_json.h"

#include "io/file/build_info.h"
#include "io/json/json_writer.h"

#include <algorithm>

namespace refraster::bench {
namespace {

/// Writes the member with `write` where there is a value, else null.
template <class Value, class Write>
void optional_member(JsonWriter& json, std::string_view name, const Value& value, const Write& write) {
  json.key(name);
  if (value) write(*value);
  else json.null();
}

void text_or_null(JsonWriter& json, std::string_view name, const std::string& text) {
  json.key(name);
  if (text.empty()) json.null();
  else json.value(text);
}

void write_numbers(JsonWriter& json, const Spread& spread) {
  json.member("min", spread.min);
  json.member("lower", spread.lower);
  json.member("median", spread.median);
  json.member("upper", spread.upper);
  json.member("max", spread.max);
}

void write_spread(JsonWriter& json, const Spread& spread) {
  json.begin_object();
  write_numbers(json, spread);
  json.end_object();
}

/// A spread of differences: whether they are larger than their spread, and if not, what they are below.
void write_difference(JsonWriter& json, const Spread& difference) {
  json.begin_object();
  write_numbers(json, difference);
  json.member("resolved", is_resolved(difference));
  json.key("below");
  if (is_resolved(difference)) json.null();
  else json.value(cost_bound(difference));
  json.end_object();
}

void difference_member(JsonWriter& json, std::string_view name, const Spread& difference) {
  json.key(name);
  write_difference(json, difference);
}

void spread_member(JsonWriter& json, std::string_view name, const Spread& spread) {
  json.key(name);
  write_spread(json, spread);
}

void optional_difference(JsonWriter& json, std::string_view name, const std::optional<Spread>& difference) {
  optional_member(json, name, difference, [&](const Spread& d) { write_difference(json, d); });
}

void write_program(JsonWriter& json) {
  const BuildInfo build = this_build();
  const Origin origin = this_origin();
  json.key("refraster");
  json.begin_object();
  json.member("version", build.version);
  json.member("compiler", build.compiler);
  json.member("type", build.type);
  json.member("march", build.march);
  json.member("isa", build.isa);
  json.member("flags", origin.flags);
  text_or_null(json, "revision", origin.revision);
  json.end_object();
}

void write_machine(JsonWriter& json, const Run& run) {
  const Machine& machine = run.machine;
  json.key("machine");
  json.begin_object();
  text_or_null(json, "cpu", machine.cpu);
  json.member("cpus", machine.cpus);
  json.member("usable_cpus", machine.usable_cpus);
  json.member("caches", machine.caches);
  json.member("memory_bytes", machine.memory_bytes);
  text_or_null(json, "virtualized", machine.virtualized);
  text_or_null(json, "kernel", machine.kernel);
  text_or_null(json, "governor", machine.governor);
  json.member("time_stamp_ghz", machine.time_stamp_ghz);
  json.key("load_average");
  json.begin_object();
  json.member("start", std::vector<double>(run.load_at_start.begin(), run.load_at_start.end()));
  json.member("end", std::vector<double>(run.load_at_end.begin(), run.load_at_end.end()));
  json.end_object();
  json.end_object();
}

void write_method(JsonWriter& json, const Run& run) {
  json.key("method");
  json.begin_object();
  json.member("warm_up_repetitions", run.warm_up);
  json.member("min_repetitions", run.min_repetitions);
  json.member("seconds", run.seconds);
  json.member("cycles", "reference cycles: of the time stamp counter, at machine.time_stamp_ghz");
  json.end_object();
}

void write_counts(JsonWriter& json, const FrameCounts& counts) {
  json.key("triangles");
  json.begin_object();
  json.member("in_scene", counts.triangles);
  json.member("drawn", counts.drawn);
  json.end_object();
  json.key("pixels");
  json.begin_object();
  json.member("in_image", counts.pixels);
  json.member("shaded", counts.shaded);
  json.member("fragments", counts.fragments);
  json.end_object();
}

void write_split(JsonWriter& json, const Split& split) {
  json.key("split_ns_per_pixel");
  json.begin_object();
  for (const auto& [name, part] : split_parts) json.member(name, split.*part);
  json.end_object();
}

void write_functions(JsonWriter& json, const std::vector<FunctionCost>& functions) {
  json.key("fragment_functions");
  json.begin_array();
  for (const FunctionCost& cost : functions) {
    json.begin_object();
    json.member("name", name_of(cost.function));
    json.member("fragments", cost.fragments);
    difference_member(json, "ns_per_fragment_and_light", cost.ns);
    json.end_object();
  }
  json.end_array();
}

void write_marginal(JsonWriter& json, const std::optional<Marginal>& marginal) {
  optional_member(json, "marginal_cpu_ns_per_pixel", marginal, [&](const Marginal& m) {
    json.begin_object();
    difference_member(json, "light", m.light);
    optional_difference(json, "texture", m.texture);
    json.key("texture_was");
    if (m.texture) json.value(m.texture_change == TextureChange::removed ? "removed" : "added");
    else json.null();
    optional_difference(json, "double_samples", m.double_samples);
    json.end_object();
  });
}

void write_figures(JsonWriter& json, std::string_view name, const ImageError::Figures& figures) {
  json.key(name);
  json.begin_object();
  json.member("max", figures.max);
  json.member("p99_9", figures.p99_9);
  json.member("mean", figures.mean);
  json.end_object();
}

void write_exact(JsonWriter& json, const ExactError& error) {
  json.key("against_exact");
  json.begin_object();
  json.member("pixels", error.pixels);
  const auto figure = [&](std::string_view name, double value) {
    json.key(name);
    if (error.pixels > 0) json.value(value);
    else json.null();
  };
  figure("max_relative", error.max_relative);
  figure("mean_relative", error.mean_relative);
  figure("max_levels", error.max_levels);
  json.end_object();
}

void write_error(JsonWriter& json, const SceneResult& scene, const std::string& precision) {
  const auto found = std::find_if(scene.errors.begin(), scene.errors.end(),
                                  [&](const PrecisionError& error) { return error.precision == precision; });
  json.key("error");
  if (found == scene.errors.end()) return json.null();
  json.begin_object();
  optional_member(json, "against_double", found->against_double, [&](const ImageError& error) {
    json.begin_object();
    json.member("pixels", error.pixels);
    write_figures(json, "levels", error.levels);
    write_figures(json, "relative", error.relative);
    json.member("off_by_one", error.off_by_one);
    json.member("off_by_more", error.off_by_more);
    json.end_object();
  });
  write_exact(json, found->against_exact);
  json.end_object();
}

const OpenGlResult* opengl_of(const SceneResult& scene, int threads) {
  for (const OpenGlResult& one : scene.opengl)
    if (one.threads == threads) return &one;
  return nullptr;
}

void write_scene_size(JsonWriter& json, const SceneResult& scene) {
  json.member("scene", scene.scene);
  json.member("size", std::vector<int>{scene.width, scene.height});
}

void write_result(JsonWriter& json, const Run& run, const SceneResult& scene, const PrecisionResult& precision) {
  json.begin_object();
  write_scene_size(json, scene);
  json.member("samples", scene.samples);
  json.member("lights", scene.lights);
  json.member("precision", precision.precision);
  json.member("threads", precision.threads);
  json.member("repetitions", scene.repetitions);
  write_counts(json, scene.counts);
  spread_member(json, "frame_ms", precision.frame_ms);
  spread_member(json, "cpu_ms", precision.cpu_ms);
  const double ns = precision.frame_ms.median * 1e6 / scene.shaded();
  json.key("per_shaded_pixel");
  json.begin_object();
  json.member("wall_ns", ns);
  json.member("cpu_ns", precision.cpu_ms.median * 1e6 / scene.shaded());
  json.member("reference_cycles", ns * run.machine.time_stamp_ghz);
  json.end_object();
  write_split(json, precision.split_ns);
  difference_member(json, "split_fragment_functions", precision.lighting_ns);
  write_functions(json, precision.functions);
  write_marginal(json, precision.marginal);
  write_error(json, scene, precision.precision);
  optional_member(json, "opengl_ratio", precision.opengl_ratio, [&](const Spread& ratio) {
    json.begin_object();
    const OpenGlResult& opengl = *opengl_of(scene, precision.threads);
    json.member("of_medians", opengl.frame_ms.median / precision.frame_ms.median);
    json.member("of_cpu_medians", opengl.cpu_ms.median / precision.cpu_ms.median);
    json.member("lower", ratio.lower);
    json.member("median", ratio.median);
    json.member("upper", ratio.upper);
    json.end_object();
  });
  json.end_object();
}

void write_opengl(JsonWriter& json, const SceneResult& scene) {
  for (const OpenGlResult& one : scene.opengl) {
    json.begin_object();
    write_scene_size(json, scene);
    json.member("threads", one.threads);
    json.member("renderer", one.renderer);
    json.member("version", one.version);
    spread_member(json, "frame_ms", one.frame_ms);
    spread_member(json, "cpu_ms", one.cpu_ms);
    json.end_object();
  }
}

void write_point(JsonWriter& json, const MeasuredPoint& measured, double time_at_first) {
  const ScalingPoint& point = measured.point;
  json.begin_object();
  json.member("n", point.n);
  json.member("size", std::vector<int>{point.width, point.height});
  json.member("threads", point.threads);
  json.member("frames", measured.frames);
  spread_member(json, "frame_ms", measured.frame_ms);
  spread_member(json, "cpu_ms", measured.cpu_ms);
  json.member("ns_per_unit", measured.frame_ms.median * 1e6 / point.n);
  json.member("speed_up", time_at_first / measured.frame_ms.median);
  optional_member(json, "peak_memory_bytes", measured.peak_memory_bytes,
                  [&](std::uint64_t bytes) { json.value(bytes); });
  write_counts(json, measured.counts);
  json.end_object();
}

void write_curve(JsonWriter& json, const ScalingCurve& curve) {
  json.begin_object();
  json.member("growth", name_of(curve.growth));
  json.key("order");
  if (curve.growth == Growth::overdraw) json.value(name_of(curve.order));
  else json.null();
  json.member("precision", curve.precision);
  json.key("points");
  json.begin_array();
  for (const MeasuredPoint& point : curve.points) write_point(json, point, curve.points.front().frame_ms.median);
  json.end_array();
  optional_member(json, "slope", curve.slope(), [&](const Slope& slope) {
    json.begin_object();
    json.member("value", slope.value);
    json.member("standard_error", slope.error);
    json.end_object();
  });
  optional_member(json, "steepest", curve.steepest(), [&](const ScalingCurve::Steepest& steepest) {
    json.begin_object();
    json.member("slope", steepest.slope);
    json.member("from", steepest.from);
    json.end_object();
  });
  optional_member(json, "no_faster_than_linear", curve.no_faster_than_linear(), [&](bool yes) { json.value(yes); });
  json.member("same_fragments", curve.same_fragments());
  json.end_object();
}

} // namespace

std::string run_json(const Run& run) {
  JsonWriter json;
  json.begin_object();
  json.member("schema", 2);
  write_program(json);
  json.member("command", run.command);
  json.member("started", run.started);
  json.member("ended", run.ended);
  write_machine(json, run);
  write_method(json, run);
  json.member("notes", run.notes);
  json.key("results");
  json.begin_array();
  for (const SceneResult& scene : run.scenes)
    for (const PrecisionResult& precision : scene.precisions) write_result(json, run, scene, precision);
  json.end_array();
  json.key("opengl");
  json.begin_array();
  for (const SceneResult& scene : run.scenes) write_opengl(json, scene);
  json.end_array();
  json.key("scaling");
  json.begin_array();
  for (const ScalingCurve& curve : run.scaling) write_curve(json, curve);
  json.end_array();
  json.end_object();
  return json.text();
}

} // namespace refraster::bench
