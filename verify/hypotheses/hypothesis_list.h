#pragma once
// The closed list of hypotheses: what may be wrong with an image, each a change of one step.

#include <refraster/scene.h>

#include "verify/hypotheses/steps.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace refraster::hypotheses {

/// What a scene must have for a hypothesis to mean anything.
enum class Concerns {
  any,
  plastics,
  measured,
  microfacets,
  textures,
  srgb_textures,
  linear_textures,
  specular_maps,
  emission,
  cut_outs,
  normal_maps,
  vertex_colours,
  two_sided,
  point_lights,
  attenuation,
  shadow_maps,
  point_shadow_maps,
  each_object,
  each_light
};

/// An entry of the list.
struct Declared {
  std::string_view key;  // for programs
  std::string_view text; // a clause: "normals transformed by the model matrix instead of its inverse transpose"
  Concerns concerns;
  void (*change)(Steps&); // of each_object and each_light: nothing, the object or light is set beside
};

/// Of what is equally good, the first is taken.
std::span<const Declared> declared_hypotheses();

/// One that is tried on a scene; those of each object or light once each, with its name in the text.
struct Hypothesis {
  std::string key, text;
  Steps steps;
};

/// Those that mean anything in this scene.
std::vector<Hypothesis> hypotheses_for(const Scene& scene);

/// The table of docs/hypotheses.md.
std::string hypotheses_markdown();

} // namespace refraster::hypotheses
