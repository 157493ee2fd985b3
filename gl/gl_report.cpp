#include "gl/gl_report.h"

#include "io/json/report_parts.h"

#include <algorithm>
#include <cstdlib>

namespace refraster {
namespace {

/// The middle one, or the mean of the middle two.
double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

void write_times(JsonWriter& json, const std::vector<double>& values) {
  if (values.empty()) return json.null();
  const auto ends = std::minmax_element(values.begin(), values.end()); // by name: clang 14 captures no bindings
  json.object([&] {
    json.member("min", *ends.first);
    json.member("median", median(values));
    json.member("max", *ends.second);
  });
}

} // namespace

std::string gl_report_json(const std::string& scene, const GlOptions& options, const GlFrame& frame) {
  JsonWriter json;
  json.object([&] {
    json.member("refraster", this_build().version);
    json.member("scene", scene);
    write_size(json, options.width, options.height);
    json.member("samples", options.samples);
    json.array("sample_positions", [&] {
      for (const GlSamplePosition& at : frame.sample_positions) json.value(std::vector<double>{at.x, at.y});
    });
    json.object("driver", [&] {
      json.member("asked_for", name_of(options.renderer));
      json.member("vendor", frame.driver.vendor);
      json.member("renderer", frame.driver.renderer);
      json.member("version", frame.driver.version);
      json.member("glsl_version", frame.driver.glsl_version);
    });
    json.object("environment", [&] { // what changes how fast Mesa's software drivers are
      for (const char* const name :
           {"GALLIUM_DRIVER", "LIBGL_ALWAYS_SOFTWARE", "LP_NUM_THREADS", "LP_NATIVE_VECTOR_WIDTH", "GALLIVM_PERF"}) {
        json.key(name);
        if (const char* const value = std::getenv(name)) json.value(value);
        else json.null();
      }
    });
    json.member("merl_filter", name_of(options.merl_filter));
    json.member("shaders", frame.shaders);
    json.member("warnings", frame.warnings);
    json.member("samples_passed", frame.samples_passed);
    json.member("nan_pixels", frame.non_finite.nan);
    json.member("infinite_pixels", frame.non_finite.infinite);
    json.member("frames", frame.times.wall_ms.size());
    json.key("frame_ms");
    write_times(json, frame.times.wall_ms);
    json.key("cpu_ms");
    write_times(json, frame.times.cpu_ms);
  });
  return json.text();
}

} // namespace refraster
