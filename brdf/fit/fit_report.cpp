// A fit, as text and as JSON.

#include "brdf/fit/channels.h"
#include "brdf/fit/fit.h"
#include "io/file/text.h"
#include "io/json/report_parts.h"

namespace refraster {
namespace {

template <class Block>
constexpr bool is_of_a_scene = requires {
  Block::shader_stems;
};

void write_value(JsonWriter& json, std::string_view name, double value) {
  json.member(name, value);
}
void write_value(JsonWriter& json, std::string_view name, const Double3& value) {
  json.member(name, channels_of(value));
}
template <NamedEnum Enum>
void write_value(JsonWriter& json, std::string_view name, Enum value) {
  json.member(name, name_of(value));
}

/// Choices stay as a scene has them by default, and are left out, and so is what the scene need not have for f.
template <class Block>
void write_parameters(JsonWriter& json, const Block& block) {
  Block::fields(block,
                [&]<class Value>(std::string_view name, const Value& value, const Range& range, std::string_view) {
                  if (range.need == Need::optional && !is_of_f(block, name)) return;
                  if constexpr (!NamedEnum<Value>) write_value(json, name, value);
                });
}

} // namespace

bool is_fragment_function(const BrdfFit& fit) {
  return fit.lobes.size() == 1 &&
         std::visit([]<class Block>(const Block&) { return is_of_a_scene<Block>; }, fit.lobes.front());
}

std::string fit_text(const Brdf& brdf, const BrdfFit& fit) {
  std::string text = format("%-16s %s\n", "reflectance", brdf.label().c_str());
  for (std::size_t k = 0; k < fit.lobes.size(); ++k) {
    text += format("%-16s %s\n", fit.lobes.size() == 1 ? "fit" : ("lobe " + std::to_string(k + 1)).c_str(),
                   std::string(model_name(fit.lobes[k])).c_str());
    for (const FitParameter& parameter : fit_parameters(fit.lobes))
      if (parameter.lobe == k) text += format("  %-14s %.6g\n", parameter.name.c_str(), parameter.value);
  }
  text += format("%-16s %.4g root mean square of ln(1 + f cos)\n", "residual", fit.log_rms);
  text += format("%-16s %.2f %%\n", "explained", 100 * fit.explained);
  text += format("%-16s %d evaluations\n", "search", fit.evaluations);
  for (const std::string& doubt : fit.doubts) text += format("%-16s %s\n", "poor", doubt.c_str());
  return text + format("%-16s %s\n", "as a model", model_text(fit.lobes).c_str());
}

std::string fit_json(const Brdf& brdf, const BrdfFit& fit) {
  JsonWriter json;
  json.object([&] {
    json.member("schema", report_schema);
    json.object("refraster", [&] { write_build(json, this_build()); });
    json.member("brdf", brdf.label());
    json.member("model", fit.model);
    json.member("text", model_text(fit.lobes));
    json.array("lobes", [&] {
      for (const BrdfModel& lobe : fit.lobes)
        json.object([&] {
          json.member("model", model_name(lobe));
          std::visit([&](const auto& block) { write_parameters(json, block); }, lobe);
        });
    });
    json.member("log_rms", fit.log_rms);
    json.member("explained", fit.explained);
    json.member("evaluations", fit.evaluations);
    json.member("poor", !fit.doubts.empty());
    json.member("doubts", fit.doubts);
  });
  return json.text();
}

std::string material_json(const BrdfFit& fit, const std::string& table) {
  JsonWriter json;
  json.object([&] {
    const bool is_table = !is_fragment_function(fit);
    json.member("fragment_function", is_table ? Merl::name : model_name(fit.lobes.front()));
    json.object("material", [&] {
      if (is_table) json.member("brdf_file_path", table);
      else std::visit([&](const auto& block) { write_parameters(json, block); }, fit.lobes.front());
    });
  });
  return json.text();
}

} // namespace refraster
