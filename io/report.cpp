#include "io/report.h"

#include "io/json_writer.h"

// CMakeLists.txt gives these to this file.
#if !defined(REFRASTER_VERSION) || !defined(REFRASTER_BUILD_TYPE) || !defined(REFRASTER_MARCH) ||                      \
    !defined(REFRASTER_FLAGS)
#error "io/CMakeLists.txt must define REFRASTER_VERSION, _BUILD_TYPE, _MARCH and _FLAGS for this file"
#endif

namespace refraster {
namespace {

std::string compiler() {
  const auto version = [](int major, int minor, int patch) {
    return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
  };
#if defined(__clang__)
  return "clang++ " + version(__clang_major__, __clang_minor__, __clang_patchlevel__);
#else
  return "g++ " + version(__GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
}

/// The x86-64 level (System V psABI, "Micro-Architecture Levels") whose instructions this build may use.
constexpr const char* isa() {
#if defined(__AVX512F__) && defined(__AVX512BW__) && defined(__AVX512CD__) && defined(__AVX512DQ__) &&                 \
    defined(__AVX512VL__)
  return "x86-64-v4";
#elif defined(__AVX2__) && defined(__FMA__) && defined(__BMI2__)
  return "x86-64-v3";
#elif defined(__SSE4_2__) && defined(__SSSE3__)
  return "x86-64-v2";
#elif defined(__x86_64__)
  return "x86-64";
#else
  return "not x86-64";
#endif
}

void write_build(JsonWriter& json, const BuildInfo& build) {
  json.begin_object();
  json.member("version", build.version);
  json.member("compiler", build.compiler);
  json.member("type", build.type);
  json.member("march", build.march);
  json.member("isa", build.isa);
  json.member("flags", build.flags);
  json.end_object();
}

void write_crop(JsonWriter& json, const std::vector<Crop>& crops) {
  if (crops.empty()) return json.null();
  const Crop& crop = crops.front();
  json.value(std::vector<int>{crop.x, crop.y, crop.width, crop.height});
}

void write_seconds(JsonWriter& json, const RunReport& report) {
  json.begin_object();
  json.member("read", report.read_seconds);
  json.member("transform", report.seconds.transform);
  json.member("bin", report.seconds.bin);
  json.member("tiles", report.seconds.tiles);
  json.member("frame", report.seconds.total);
  json.member("write", report.write_seconds);
  json.end_object();
}

void write_counts(JsonWriter& json, const FrameCounts& counts) {
  json.begin_object();
  json.key("triangles");
  json.begin_object();
  json.member("in_scene", counts.triangles);
  json.member("not_finite", counts.not_finite);
  json.member("outside", counts.outside);
  json.member("degenerate", counts.degenerate);
  json.member("culled", counts.culled);
  json.member("between_samples", counts.between_samples);
  json.member("drawn", counts.drawn);
  json.member("clipped", counts.clipped);
  json.end_object();
  json.key("pixels");
  json.begin_object();
  json.member("in_image", counts.pixels);
  json.member("shaded", counts.shaded);
  json.member("fragments", counts.fragments);
  json.member("lane_slots", counts.lane_slots);
  json.key("occupancy");
  if (counts.lane_slots > 0) json.value(static_cast<double>(counts.fragments) / static_cast<double>(counts.lane_slots));
  else json.null();
  json.end_object();
  json.key("undefined");
  json.begin_object();
  for (std::size_t i = 0; i < undefined_names.size(); ++i) json.member(undefined_names[i], counts.undefined.counts[i]);
  json.end_object();
  json.end_object();
}

} // namespace

BuildInfo this_build() {
  return {REFRASTER_VERSION, compiler(), REFRASTER_BUILD_TYPE, REFRASTER_MARCH, isa(), REFRASTER_FLAGS};
}

std::string report_json(const RunReport& report) {
  JsonWriter json;
  json.begin_object();
  json.key("refraster");
  write_build(json, this_build());
  json.member("scene", report.scene);
  json.member("outputs", report.outputs);
  json.member("size", std::vector<int>{report.width, report.height});
  json.key("crop");
  write_crop(json, report.crop);
  json.member("rung", report.rung);
  json.member("samples", report.samples);
  json.member("threads", report.threads);
  json.member("tile_size", report.tile_size);
  json.key("seconds");
  write_seconds(json, report);
  json.key("counts");
  write_counts(json, report.counts);
  json.member("notes", report.notes);
  json.end_object();
  return json.text();
}

} // namespace refraster
