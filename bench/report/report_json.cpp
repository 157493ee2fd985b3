#include "bench/report/report_json.h"

#include "io/json/report_parts.h"

#include <algorithm>

namespace refraster::bench {
namespace {

void write_numbers(JsonWriter& json, const Spread& spread) {
  json.member("min", spread.min);
  json.member("lower", spread.lower);
  json.member("median", spread.median);
  json.member("upper", spread.upper);
  json.member("max", spread.max);
}

void write_spread(JsonWriter& json, const Spread& spread) {
  json.object([&] { write_numbers(json, spread); });
}

/// A spread of differences: whether they are larger than their spread, and if not, what they are below.
void write_difference(JsonWriter& json, const Spread& difference) {
  json.object([&] {
    write_numbers(json, difference);
    json.member("resolved", is_resolved(difference));
    json.key("below");
    if (is_resolved(difference)) json.null();
    else json.value(cost_bound(difference));
  });
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
  json.optional(name, difference, [&](const Spread& d) { write_difference(json, d); });
}

void write_program(JsonWriter& json) {
  const Origin origin = this_origin();
  BuildInfo build = this_build();
  build.flags = origin.flags; // those of all layers
  json.object("refraster", [&] {
    write_build(json, build);
    json.text_or_null("revision", origin.revision);
  });
}

void write_machine(JsonWriter& json, const Run& run) {
  const Machine& machine = run.machine;
  json.object("machine", [&] {
    json.text_or_null("cpu", machine.cpu);
    json.member("cpus", machine.cpus);
    json.member("usable_cpus", machine.usable_cpus);
    json.member("caches", machine.caches);
    json.member("memory_bytes", machine.memory_bytes);
    json.text_or_null("virtualized", machine.virtualized);
    json.text_or_null("kernel", machine.kernel);
    json.text_or_null("governor", machine.governor);
    json.member("time_stamp_ghz", machine.time_stamp_ghz);
    json.object("load_average", [&] {
      json.member("start", std::vector<double>(run.load_at_start.begin(), run.load_at_start.end()));
      json.member("end", std::vector<double>(run.load_at_end.begin(), run.load_at_end.end()));
    });
  });
}

void write_method(JsonWriter& json, const Run& run) {
  json.object("method", [&] {
    json.member("warm_up_repetitions", run.warm_up);
    json.member("min_repetitions", run.min_repetitions);
    json.member("seconds", run.seconds);
    json.member("cycles", "reference cycles: of the time stamp counter, at machine.time_stamp_ghz");
  });
}

void write_counts(JsonWriter& json, const FrameCounts& counts) {
  json.object("triangles", [&] {
    json.member("in_scene", counts.triangles);
    json.member("drawn", counts.drawn);
  });
  json.object("pixels", [&] {
    json.member("in_image", counts.pixels);
    json.member("shaded", counts.shaded);
    json.member("fragments", counts.fragments);
  });
}

void write_split(JsonWriter& json, const Split& split) {
  json.object("split_ns_per_pixel", [&] {
    for (const auto& [name, part] : split_parts) json.member(name, split.*part);
  });
}

void write_functions(JsonWriter& json, const std::vector<FunctionCost>& functions) {
  json.array("fragment_functions", [&] {
    for (const FunctionCost& cost : functions) {
      json.object([&] {
        json.member("name", name_of(cost.function));
        json.member("fragments", cost.fragments);
        difference_member(json, "ns_per_fragment_and_light", cost.ns);
      });
    }
  });
}

void write_marginal(JsonWriter& json, const std::optional<Marginal>& marginal) {
  json.optional("marginal_cpu_ns_per_pixel", marginal, [&](const Marginal& m) {
    json.object([&] {
      difference_member(json, "light", m.light);
      optional_difference(json, "texture", m.texture);
      json.key("texture_was");
      if (m.texture) json.value(m.texture_change == TextureChange::removed ? "removed" : "added");
      else json.null();
      optional_difference(json, "double_samples", m.double_samples);
    });
  });
}

void write_figures(JsonWriter& json, std::string_view name, const ImageError::Figures& figures) {
  json.object(name, [&] {
    json.member("max", figures.max);
    json.member("p99_9", figures.p99_9);
    json.member("mean", figures.mean);
  });
}

void write_exact(JsonWriter& json, const ExactError& error) {
  json.object("against_exact", [&] {
    json.member("pixels", error.pixels);
    const auto figure = [&](std::string_view name, double value) {
      json.key(name);
      if (error.pixels > 0) json.value(value);
      else json.null();
    };
    figure("max_relative", error.max_relative);
    figure("mean_relative", error.mean_relative);
    figure("max_levels", error.max_levels);
  });
}

void write_error(JsonWriter& json, const SceneResult& scene, const std::string& precision) {
  const auto found = std::find_if(scene.errors.begin(), scene.errors.end(),
                                  [&](const PrecisionError& error) { return error.precision == precision; });
  json.key("error");
  if (found == scene.errors.end()) return json.null();
  json.object([&] {
    json.optional("against_double", found->against_double, [&](const ImageError& error) {
      json.object([&] {
        json.member("pixels", error.pixels);
        write_figures(json, "levels", error.levels);
        write_figures(json, "relative", error.relative);
        json.member("off_by_one", error.off_by_one);
        json.member("off_by_more", error.off_by_more);
      });
    });
    write_exact(json, found->against_exact);
  });
}

const OpenGlResult* opengl_of(const SceneResult& scene, int threads) {
  for (const OpenGlResult& one : scene.opengl)
    if (one.threads == threads) return &one;
  return nullptr;
}

void write_scene_size(JsonWriter& json, const SceneResult& scene) {
  json.member("scene", scene.scene);
  write_size(json, scene.width, scene.height);
}

void write_result(JsonWriter& json, const Run& run, const SceneResult& scene, const PrecisionResult& precision) {
  json.object([&] {
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
    json.object("per_shaded_pixel", [&] {
      json.member("wall_ns", ns);
      json.member("cpu_ns", precision.cpu_ms.median * 1e6 / scene.shaded());
      json.member("reference_cycles", ns * run.machine.time_stamp_ghz);
    });
    write_split(json, precision.split_ns);
    difference_member(json, "split_fragment_functions", precision.lighting_ns);
    write_functions(json, precision.functions);
    write_marginal(json, precision.marginal);
    write_error(json, scene, precision.precision);
    json.optional("opengl_ratio", precision.opengl_ratio, [&](const Spread& ratio) {
      json.object([&] {
        const OpenGlResult& opengl = *opengl_of(scene, precision.threads);
        json.member("of_medians", opengl.frame_ms.median / precision.frame_ms.median);
        json.member("of_cpu_medians", opengl.cpu_ms.median / precision.cpu_ms.median);
        json.member("lower", ratio.lower);
        json.member("median", ratio.median);
        json.member("upper", ratio.upper);
      });
    });
  });
}

void write_opengl(JsonWriter& json, const SceneResult& scene) {
  for (const OpenGlResult& one : scene.opengl) {
    json.object([&] {
      write_scene_size(json, scene);
      json.member("threads", one.threads);
      json.member("renderer", one.renderer);
      json.member("version", one.version);
      spread_member(json, "frame_ms", one.frame_ms);
      spread_member(json, "cpu_ms", one.cpu_ms);
    });
  }
}

void write_commands(JsonWriter& json, const SceneResult& scene) {
  for (const CommandResult& command : scene.commands) {
    json.object([&] {
      write_scene_size(json, scene);
      json.member("samples", scene.samples);
      json.member("precision", command.precision);
      json.member("threads", command.threads);
      json.member("repetitions", command.repetitions);
      for (const auto& [name, part] : command_parts) spread_member(json, std::string(name) + "_ms", command.*part);
    });
  }
}

void write_point(JsonWriter& json, const MeasuredPoint& measured, double time_at_first) {
  const ScalingPoint& point = measured.point;
  json.object([&] {
    json.member("n", point.n);
    write_size(json, point.width, point.height);
    json.member("threads", point.threads);
    json.member("frames", measured.frames);
    spread_member(json, "frame_ms", measured.frame_ms);
    spread_member(json, "cpu_ms", measured.cpu_ms);
    json.member("ns_per_unit", measured.frame_ms.median * 1e6 / point.n);
    json.member("speed_up", time_at_first / measured.frame_ms.median);
    json.optional("peak_memory_bytes", measured.peak_memory_bytes, [&](std::uint64_t bytes) { json.value(bytes); });
    write_counts(json, measured.counts);
  });
}

void write_curve(JsonWriter& json, const ScalingCurve& curve) {
  json.object([&] {
    json.member("growth", name_of(curve.growth));
    json.key("order");
    if (curve.growth == Growth::overdraw) json.value(name_of(curve.order));
    else json.null();
    json.member("precision", curve.precision);
    json.array("points", [&] {
      for (const MeasuredPoint& point : curve.points) write_point(json, point, curve.points.front().frame_ms.median);
    });
    json.optional("slope", curve.slope(), [&](const Slope& slope) {
      json.object([&] {
        json.member("value", slope.value);
        json.member("standard_error", slope.error);
      });
    });
    json.optional("steepest", curve.steepest(), [&](const ScalingCurve::Steepest& steepest) {
      json.object([&] {
        json.member("slope", steepest.slope);
        json.member("from", steepest.from);
      });
    });
    json.optional("no_faster_than_linear", curve.no_faster_than_linear(), [&](bool yes) { json.value(yes); });
    json.member("same_fragments", curve.same_fragments());
  });
}

} // namespace

std::string run_json(const Run& run) {
  JsonWriter json;
  json.object([&] {
    json.member("schema", report_schema);
    write_program(json);
    json.member("command", run.command);
    json.member("started", run.started);
    json.member("ended", run.ended);
    write_machine(json, run);
    write_method(json, run);
    json.member("notes", run.notes);
    json.array("results", [&] {
      for (const SceneResult& scene : run.scenes)
        for (const PrecisionResult& precision : scene.precisions) write_result(json, run, scene, precision);
    });
    json.array("opengl", [&] {
      for (const SceneResult& scene : run.scenes) write_opengl(json, scene);
    });
    json.array("commands", [&] {
      for (const SceneResult& scene : run.scenes) write_commands(json, scene);
    });
    json.array("scaling", [&] {
      for (const ScalingCurve& curve : run.scaling) write_curve(json, curve);
    });
  });
  return json.text();
}

} // namespace refraster::bench
