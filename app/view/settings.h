#pragma once
// What keys change of the picture, and how a command line says the same.

#include <refraster/frame.h>
#include <refraster/scene.h>

#include "app/view/keys.h"
#include "io/scene/scene_edits.h"

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace refraster {

enum class ShadowsShown { of_scene, all, none };
enum class TriangleEdges { hidden, shown };

struct ViewSettings {
  Precision precision = Precision::double_; // of the still picture
  std::set<std::size_t> dark_lights;        // that are off: numbers from 0, in the order of light_lists
  ShadowsShown shadows = ShadowsShown::of_scene;
  std::optional<Aov> aov; // in the place of the colour
  TriangleEdges edges = TriangleEdges::hidden;
  bool operator==(const ViewSettings&) const = default;
};

/// The one after, round and round.
Precision next_precision(Precision precision);
/// The one after; after the last, the colour again.
std::optional<Aov> next_aov(std::optional<Aov> aov);
/// Shadows off if the scene shows any, else on; and back.
ShadowsShown switched(ShadowsShown shown, const Scene& scene);

/// Does what a key says, by its action and name, and gives what is said of it in a line, which may be empty. Nothing
/// for a key that changes no settings.
std::optional<std::string> change(ViewSettings& settings, KeyAction action, std::string_view key, const Scene& scene);

/// Lights and shadows as the settings have them.
void apply(const ViewSettings& settings, Scene& scene);
/// The same changes to the text of the scene's file.
std::vector<SceneEdit> scene_edits(const ViewSettings& settings, const Scene& scene);

/// "point light 1", "direction light 0": counted from 0, as in explain; empty for a number that no light has.
std::string light_name(const Scene& scene, std::size_t number);

} // namespace refraster
