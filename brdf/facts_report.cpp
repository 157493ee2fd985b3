// What is known of a reflectance, for people and for programs.

#include "brdf/facts.h"
#include "brdf/fit/channels.h"

#include "io/brdf/merl_file.h"
#include "io/file/sha256.h"
#include "io/file/text.h"
#include "io/json/report_parts.h"

namespace refraster {
namespace {

std::string rgb_row(const std::string& label, const Rgb<double>& rgb) {
  return format("%-16s %12.6g %12.6g %12.6g\n", label.c_str(), rgb.x, rgb.y, rgb.z);
}

std::string row(const char* label, const std::string& words) {
  return format("%-16s %s\n", label, words.c_str());
}

std::string source_text(const BrdfInfo& info) {
  std::string text;
  if (const std::vector<BrdfModel>* const lobes = info.brdf.lobes()) {
    for (const BrdfModel& lobe : *lobes) {
      text += row("model", std::string(model_name(lobe)) + ": " + std::string(model_meaning(lobe)));
      text += row("", model_text(lobe));
    }
    return text;
  }
  text += row("file", info.brdf.label());
  text += row("material", info.material.empty() ? "not one of the 100 of the database" : info.material);
  text += row("samples", format("%d x %d x %d (theta_h, theta_d, phi_d)", MerlTable::theta_h_bins,
                                MerlTable::theta_d_bins, MerlTable::phi_d_bins));
  return text + row("never measured",
                    format("%llu (%.2f %%)", static_cast<unsigned long long>(info.facts.never_measured),
                           100 * static_cast<double>(info.facts.never_measured) / double{MerlTable::samples}));
}

} // namespace

BrdfInfo brdf_info(const Brdf& brdf) {
  const std::string material = brdf.table() ? std::string(merl_material_name(file_sha256(brdf.label()))) : "";
  return {brdf, material, brdf_facts(brdf)};
}

std::string info_text(const BrdfInfo& info) {
  const auto per_channel = [&](double ChannelFacts::*fact) {
    return Rgb<double>(info.facts.channels[0].*fact, info.facts.channels[1].*fact, info.facts.channels[2].*fact);
  };
  std::string text = source_text(info);
  text += format("%-16s %12s %12s %12s\n", "f, 1/sr", "red", "green", "blue");
  text += rgb_row("  min", per_channel(&ChannelFacts::min));
  text += rgb_row("  max", per_channel(&ChannelFacts::max));
  text += rgb_row("  mean", per_channel(&ChannelFacts::mean));
  text += "albedo, light at\n";
  for (const AlbedoFact& fact : info.facts.albedos)
    text += rgb_row("  " + std::to_string(static_cast<int>(fact.degrees)) + " degrees", fact.albedo);
  return text + row("f(i,o) - f(o,i)", format("%.3g relative, the most of %d pairs of directions",
                                              info.facts.reciprocity_error, info.facts.reciprocity_pairs));
}

std::string info_json(const BrdfInfo& info) {
  JsonWriter json;
  json.object([&] {
    json.member("schema", report_schema);
    json.object("refraster", [&] { write_build(json, this_build()); });
    json.member("brdf", info.brdf.label());
    json.text_or_null("model", info.brdf.lobes() ? model_text(*info.brdf.lobes()) : "");
    json.text_or_null("material", info.material);
    json.member("samples", info.facts.samples);
    json.member("never_measured", info.facts.never_measured);
    const auto channel_member = [&](std::string_view name, double ChannelFacts::*fact) {
      json.array(name, [&] {
        for (const ChannelFacts& channel : info.facts.channels) json.value(channel.*fact);
      });
    };
    channel_member("min", &ChannelFacts::min);
    channel_member("max", &ChannelFacts::max);
    channel_member("mean", &ChannelFacts::mean);
    json.array("albedo", [&] {
      for (const AlbedoFact& fact : info.facts.albedos)
        json.object([&] {
          json.member("theta_in", fact.degrees);
          json.member("albedo", channels_of(fact.albedo));
        });
    });
    json.member("reciprocity_error", info.facts.reciprocity_error);
    json.member("notes", impossibilities(info.facts));
  });
  return json.text();
}

} // namespace refraster
