#include "io/json/report_parts.h"
#include "verify/verdict/verdict_report.h"

#include <algorithm>

namespace refraster {
namespace {

/// Unexplained pixels and clusters that are listed: more than anyone reads, fewer than make a file large.
constexpr std::size_t max_listed = 1000;

std::vector<double> channels(const Double3& v) {
  return {v.x, v.y, v.z};
}

void write_classes(JsonWriter& json, const Verdict& verdict) {
  json.object("pixels", [&] {
    json.member("all", verdict.classes.values.size());
    for (const auto& [pixel_class, name] : EnumNames<PixelClass>::names) json.member(name, verdict.count(pixel_class));
  });
}

void write_unexplained(JsonWriter& json, const Verdict& verdict) {
  json.array("unexplained", [&] {
    std::size_t listed = 0;
    for (const JudgedDetail& detail : verdict.details) {
      if (detail.found != PixelClass::unexplained || listed++ >= max_listed) continue;
      json.object([&] {
        json.member("x", detail.x);
        json.member("y", detail.y);
        json.member("objection", name_of(detail.objection));
        json.member("object", detail.object);
        json.member("triangle", detail.triangle);
        json.member("actual", channels(detail.actual));
        json.member("reference", channels(detail.reference));
        json.member("allowed_from", channels(detail.allowed.lo));
        json.member("allowed_to", channels(detail.allowed.hi));
        json.member("surfaces", detail.surfaces);
      });
    }
  });
  json.array("clusters", [&] {
    for (std::size_t i = 0; i < std::min(verdict.clusters.size(), max_listed); ++i) {
      const Cluster& c = verdict.clusters[i].where;
      json.object([&] {
        json.member("box", std::vector<int>{c.x, c.y, c.width, c.height});
        json.member("pixels", c.pixels);
        json.member("worst", std::vector<int>{c.worst_x, c.worst_y});
        json.member("object", verdict.clusters[i].object);
      });
    }
  });
}

} // namespace

std::string verdict_json(const VerdictReport& report) {
  const Verdict& verdict = report.verdict;
  JsonWriter json;
  json.object([&] {
    json.member("schema", report_schema);
    json.object("refraster", [&] { write_build(json, this_build()); });
    json.member("scene", report.scene);
    json.member("actual", report.actual);
    json.object("device", [&] {
      json.member("name", report.profile.name);
      json.member("version", report.profile.version);
      json.member("meaning", report.profile.meaning);
    });
    write_size(json, verdict.width, verdict.height);
    json.member("samples", report.options.samples);
    json.member("srgb", report.transfer == Transfer::srgb);
    json.member("matrices", name_of(report.options.matrices));
    json.member("explained", verdict.is_explained());
    json.member("passes", report.passes());
    json.array("limits", [&] {
      for (const ClassLimit& limit : report.limits)
        json.object([&] {
          json.member("class", name_of(limit.pixel_class));
          json.member("most", limit.most);
        });
    });
    write_classes(json, verdict);
    json.object("power", [&] {
      json.member("pixels", verdict.power.pixels);
      json.member("below_0.1", verdict.power.below_tenth);
      json.member("below_1", verdict.power.below_one);
      json.member("below_4", verdict.power.below_four);
      json.member("median", verdict.power.median);
    });
    json.object("causes", [&] {
      for (std::size_t i = 0; i < verdict.causes.size(); ++i) json.member(bound_cause_names[i], verdict.causes[i]);
    });
    json.array("drift", [&] {
      for (const ObjectBias& bias : verdict.biases)
        json.object([&] {
          json.member("object", bias.object + 1);
          json.member("values", bias.values);
          json.member("mean", bias.mean);
          json.member("allowed", bias.allowed);
          json.member("moved", bias.moved);
          json.member("allowed_moved", bias.allowed_moved);
          json.member("biased", bias.is_biased());
        });
    });
    write_unexplained(json, verdict);
    json.optional("hypotheses", report.ranking, [&](const hypotheses::Ranking& ranking) {
      json.object([&] {
        json.member("tried", ranking.tried);
        json.member("named", ranking.named() != nullptr);
        json.array("causes", [&] {
          for (std::size_t i = 0; i < ranking.causes.size(); ++i)
            json.object([&] {
              const hypotheses::Cause& cause = ranking.causes[i];
              json.member("keys", cause.keys);
              json.member("text", report.cause_sentences[i]);
              json.member("explained", cause.explained);
              json.member("kept", cause.kept);
            });
        });
      });
    });
    json.object("provenance", [&] {
      for (const auto& [label, content] : report.provenance) json.member(label, content);
    });
    json.array("notes", [&] {
      for (const Note& note : report.notes.notes()) json.value(note.text());
    });
  });
  return json.text();
}

} // namespace refraster
