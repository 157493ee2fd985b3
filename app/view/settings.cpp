#include "app/view/settings.h"

#include <iterator>

namespace refraster {
namespace {

/// Calls visit(light, its list's names, its number in the list, its number of all).
void for_each_light(auto& scene, auto&& visit) {
  std::size_t number = 0;
  for_each_light_list(scene, [&](auto& lights) {
    for (std::size_t i = 0; i < lights.size(); ++i) {
      using Light = std::remove_cvref_t<decltype(lights[i])>;
      visit(lights[i], Light::names, i, number++);
    }
  });
}

/// Nothing where each light has its own.
std::optional<Shadow> shadow_of(ShadowsShown shown) {
  switch (shown) {
  case ShadowsShown::all:
    return Shadow::exact;
  case ShadowsShown::none:
    return Shadow::none;
  case ShadowsShown::of_scene:
    break;
  }
  return std::nullopt;
}

} // namespace

Precision next_precision(Precision precision) {
  const auto& names = EnumNames<Precision>::names;
  for (std::size_t i = 0; i + 1 < std::size(names); ++i)
    if (names[i].first == precision) return names[i + 1].first;
  return names[0].first;
}

std::optional<Aov> next_aov(std::optional<Aov> aov) {
  const std::size_t next = aov ? static_cast<std::size_t>(*aov) + 1 : 0;
  if (next == std::size(aov_kinds)) return std::nullopt;
  return static_cast<Aov>(next);
}

ShadowsShown switched(ShadowsShown shown, const Scene& scene) {
  if (shown != ShadowsShown::of_scene) return ShadowsShown::of_scene;
  return has_shadows(scene) ? ShadowsShown::none : ShadowsShown::all;
}

std::optional<std::string> change(ViewSettings& settings, KeyAction action, std::string_view key, const Scene& scene) {
  switch (action) {
  case KeyAction::precision:
    settings.precision = next_precision(settings.precision);
    return "precision: " + std::string(name_of(settings.precision));
  case KeyAction::light: {
    const auto number = static_cast<std::size_t>(key[0] - '1');
    const std::string name = light_name(scene, number);
    if (name.empty()) return "there is no light " + std::string(key);
    if (settings.dark_lights.erase(number) > 0) return name + " on";
    settings.dark_lights.insert(number);
    return name + " off";
  }
  case KeyAction::shadows:
    settings.shadows = switched(settings.shadows, scene);
    if (settings.shadows == ShadowsShown::of_scene) return "shadows: as the scene says";
    return settings.shadows == ShadowsShown::all ? "shadows: of all lights" : "shadows: none";
  case KeyAction::edges:
    settings.edges = settings.edges == TriangleEdges::shown ? TriangleEdges::hidden : TriangleEdges::shown;
    return "";
  case KeyAction::aov:
    settings.aov = next_aov(settings.aov);
    return settings.aov ? "" : "colour";
  default:
    return std::nullopt;
  }
}

void apply(const ViewSettings& settings, Scene& scene) {
  const std::optional<Shadow> shadow = shadow_of(settings.shadows);
  for_each_light(scene, [&](auto& light, const LightNames&, std::size_t, std::size_t number) {
    if (settings.dark_lights.contains(number)) light.radiance = Double3(0);
    if (shadow) light.shadow = *shadow;
  });
}

std::vector<SceneEdit> scene_edits(const ViewSettings& settings, const Scene& scene) {
  const std::optional<Shadow> shadow = shadow_of(settings.shadows);
  std::vector<SceneEdit> edits;
  for_each_light(scene, [&](const auto&, const LightNames& names, std::size_t i, std::size_t number) {
    const std::string light = "/scene/" + std::string(names.key) + "/" + std::to_string(i);
    if (settings.dark_lights.contains(number)) edits.push_back({light + "/radiance", "[0, 0, 0]", "--set"});
    if (shadow) edits.push_back({light + "/shadow", json_string(name_of(*shadow)), "--set"});
  });
  return edits;
}

std::string light_name(const Scene& scene, std::size_t wanted) {
  std::string name;
  for_each_light(scene, [&](const auto&, const LightNames& names, std::size_t i, std::size_t number) {
    if (number != wanted) return;
    name = names.words; // "point lights"
    name.pop_back();
    name += " " + std::to_string(i);
  });
  return name;
}

} // namespace refraster
