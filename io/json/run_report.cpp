#include "io/json/run_report.h"

#include "io/json/report_parts.h"

namespace refraster {
namespace {

void write_crop(JsonWriter& json, const std::optional<PixelRect>& crop) {
  if (!crop) return json.null();
  json.value(std::vector<int>{crop->x, crop->y, crop->width, crop->height});
}

void write_seconds(JsonWriter& json, const RunReport& report) {
  json.object([&] {
    json.member("read", report.read_seconds);
    json.member("transform", report.seconds.transform);
    json.member("bin", report.seconds.bin);
    json.member("tiles", report.seconds.tiles);
    json.member("frame", report.seconds.total);
    json.member("write", report.write_seconds);
  });
}

void write_counts(JsonWriter& json, const FrameCounts& counts) {
  json.object([&] {
    json.object("triangles", [&] {
      json.member("in_scene", counts.triangles);
      json.member("not_finite", counts.not_finite);
      json.member("outside", counts.outside);
      json.member("degenerate", counts.degenerate);
      json.member("culled", counts.culled);
      json.member("between_samples", counts.between_samples);
      json.member("drawn", counts.drawn);
      json.member("clipped", counts.clipped);
    });
    json.object("pixels", [&] {
      json.member("in_image", counts.pixels);
      json.member("shaded", counts.shaded);
      json.member("fragments", counts.fragments);
      json.member("lane_slots", counts.lane_slots);
      json.key("occupancy");
      if (counts.lane_slots > 0)
        json.value(static_cast<double>(counts.fragments) / static_cast<double>(counts.lane_slots));
      else json.null();
    });
    json.object("undefined", [&] {
      for (std::size_t i = 0; i < undefined_names.size(); ++i)
        json.member(undefined_names[i], counts.undefined.counts[i]);
    });
  });
}

} // namespace

std::string report_json(const RunReport& report) {
  JsonWriter json;
  json.object([&] {
    json.member("schema", report_schema);
    json.object("refraster", [&] { write_build(json, this_build()); });
    json.member("scene", report.scene);
    json.member("outputs", report.outputs);
    write_size(json, report.width, report.height);
    json.key("crop");
    write_crop(json, report.crop);
    json.member("precision", report.precision);
    json.member("samples", report.samples);
    json.member("threads", report.threads);
    json.member("tile_size", report.tile_size);
    json.key("seconds");
    write_seconds(json, report);
    json.key("counts");
    write_counts(json, report.counts);
    json.member("notes", report.notes);
  });
  return json.text();
}

} // namespace refraster
