#include "io/scene/model/mtl_material.h"

#include "io/file/text.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace refraster {
namespace {

// What the format takes for Kd that is not there: "Object Files", Wavefront, Advanced Visualizer, appendix B1's
// companion on materials. A texture alone is to be seen as it is, as three.js and assimp show it.
constexpr double default_diffuse = 0.8;

// The format has no highlight by default (Ns 0); viewers take a plain one where Ks is given and Ns is not, as
// MeshPhongMaterial of three.js.
constexpr double default_exponent = 30;

/// Exporters that know of no ambient reflection write 0 or 1, whatever the colour: 3ds Max and Blender.
bool says_nothing(const std::optional<Double3>& ambient) {
  return !ambient || *ambient == Double3(0) || *ambient == Double3(1);
}

} // namespace

PhongParameters phong_parameters(const MeshMaterial& material) {
  const Double3 diffuse = material.diffuse.value_or(Double3(material.diffuse_map.path.empty() ? default_diffuse : 1));
  PhongParameters result;
  result.specular_gate = SpecularGate::cut_below_horizon;
  if (material.illumination == 0) { // a constant colour
    result.ka = diffuse, result.kd = result.ks = Double3(0);
    return result;
  }
  result.ka = ambient_light_of_files * (says_nothing(material.ambient) ? diffuse : *material.ambient);
  result.kd = diffuse;
  result.ks = material.specular.value_or(Double3(material.specular_map.path.empty() ? 0 : 1));
  result.glossiness = material.exponent.value_or(default_exponent);
  // An exponent of 0 would be a highlight wherever light arrives: files that have it mean none.
  if (material.illumination == 1 || result.glossiness == 0) result.ks = Double3(0);
  return result;
}

Microfacet microfacet_parameters(const MeshMaterial& material) {
  const PhongParameters phong = phong_parameters(material);
  const auto fraction = [](const std::optional<double>& given, const MeshTexture& map, double otherwise) {
    return std::clamp(given.value_or(map.path.empty() ? otherwise : 1), 0.0, 1.0);
  };
  Microfacet result;
  const Double3& colour = material.illumination == 0 ? phong.ka : phong.kd;
  // More than 1 would reflect more light than arrives.
  for (int c = 0; c < 3; ++c) result.base_color[c] = std::min(colour[c], 1.0);
  // alpha^2 = 2 / (s + 2) gives a density of the same slope at its middle as a power s of n.h: Walter et al.,
  // "Microfacet models for refraction through rough surfaces", 2007, section 5.2. alpha is roughness^2.
  const double of_exponent = std::sqrt(std::sqrt(2 / (std::max(phong.glossiness, 0.0) + 2)));
  result.roughness = fraction(material.roughness, material.roughness_map, of_exponent);
  result.metallic = fraction(material.metallic, material.metallic_map, 0);
  return result;
}

Double3 emissive_colour(const MeshMaterial& material) {
  return material.emissive.value_or(Double3(material.emissive_map.path.empty() ? 0 : 1));
}

ScalarChannel scalar_channel(const MeshTexture& map, ScalarChannel otherwise) {
  switch (map.channel) {
  case 'r':
    return ScalarChannel::red;
  case 'g':
    return ScalarChannel::green;
  case 'b':
    return ScalarChannel::blue;
  case 'm':
    return ScalarChannel::alpha;
  case 'l':
    return ScalarChannel::luminance;
  default: // none, or z, a depth, which images do not have
    return otherwise;
  }
}

void note_what_is_not_shown(const MeshMaterial& material, FileFunction function, NoteList& notes) {
  const auto note = [&](const std::string& what, const char* consequence) {
    notes.add({material.file, material.line, "material " + in_quotes(material.name) + " with " + what, consequence});
  };
  if (material.dissolve.value_or(1) < 1)
    note("d below 1", material.dissolve_map.path.empty() ? "drawn opaque: there is no blending"
                                                         : "read without it: map_d alone says what is cut out");
  if (material.illumination.value_or(2) > 2)
    note("illum " + std::to_string(*material.illumination), "read as illum 2: nothing is mirrored or seen through");
  if (material.exponent == 0.0 && material.specular.value_or(Double3(0)) != Double3(0) && material.illumination != 1)
    note("Ns 0", "drawn without a highlight");
  if (function == FileFunction::microfacet) {
    if (material.specular.value_or(Double3(0)) != Double3(0) || !material.specular_map.path.empty())
      note("Ks", "drawn without it: microfacets reflect by Kd, Pr and Pm");
  } else if (material.roughness || material.metallic || !material.roughness_map.path.empty() ||
             !material.metallic_map.path.empty()) {
    note("Pr or Pm", "drawn by Kd, Ks and Ns: roughness and metalness are for the fragment function microfacet");
  }
  if (!material.ambient_map.path.empty() && material.ambient_map.path != material.diffuse_map.path)
    note("map_Ka", "read without map_Ka: ambient light is coloured by map_Kd");
  for (const MeshTexture* const map :
       {&material.diffuse_map, &material.specular_map, &material.emissive_map, &material.normal_map})
    if (map->channel != 0 && map->channel != 'm') note("-imfchan", "read without -imfchan: a colour has all channels");
  if (material.dissolve_map.channel == 'z' || material.bump_map.channel == 'z')
    note("-imfchan z", "read without -imfchan: an image has no depth");
}

} // namespace refraster
