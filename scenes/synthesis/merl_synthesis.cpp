#include "scenes/synthesis/merl_synthesis.h"

#include <numbers>

namespace refraster {

namespace {

constexpr double right_angle = 90; // degrees

// Colours of the metals: reflectance at normal incidence from refractive indices published for red, green and blue,
// rounded to two digits. Widths and albedos are chosen by eye.
const BrdfPreset presets[] = {
    {"lambert", "matt white, albedo 0.8", Lambert{Double3(0.8)}},
    {"chrome-like", "smooth grey metal, alpha 0.05", GgxConductor{0.05, {0.55, 0.56, 0.55}}},
    {"brass-like", "polished yellow metal, alpha 0.1", GgxConductor{0.1, {0.91, 0.78, 0.42}}},
    {"copper-like", "red metal, alpha 0.15", GgxConductor{0.15, {0.95, 0.64, 0.54}}},
    {"aluminium-like", "brushed light metal, alpha 0.3", GgxConductor{0.3, {0.91, 0.92, 0.92}}},
    {"nylon-like", "white polymer, ior 1.53, alpha 0.3", GgxDielectric{0.3, 1.53, Double3(0.6)}},
    {"red-plastic-like", "glossy red polymer, ior 1.5, alpha 0.1", GgxDielectric{0.1, 1.5, {0.6, 0.05, 0.03}}},
    {"rubber-like", "dark dull polymer, ior 1.52, alpha 0.5", GgxDielectric{0.5, 1.52, Double3(0.04)}},
};

} // namespace

DirectionPair directions_of(const SineCosine& theta_h, const SineCosine& theta_d, const SineCosine& before_middle) {
  const double x = theta_d.sine * before_middle.sine, y = theta_d.sine * before_middle.cosine, z = theta_d.cosine;
  return {{theta_h.cosine * x + theta_h.sine * z, y, theta_h.cosine * z - theta_h.sine * x},
          {theta_h.sine * z - theta_h.cosine * x, -y, theta_h.cosine * z + theta_h.sine * x}};
}

DirectionPair directions_at_centre(int h, int d, int p) {
  const double root_of_fraction = (h + 0.5) / MerlTable::theta_h_bins; // the table is even in sqrt(theta_h)
  const SineCosine theta_h = sine_cosine_of_degrees(root_of_fraction * root_of_fraction * right_angle);
  const SineCosine theta_d = sine_cosine_of_degrees((d + 0.5) / MerlTable::theta_d_bins * right_angle);
  // From phi_d = pi/2, in both directions alike: cos phi_d changes its sign from p to 179 - p and nothing else.
  const SineCosine before_middle = sine_cosine_of_degrees((89.5 - p) / MerlTable::phi_d_bins * 180);
  return directions_of(theta_h, theta_d, before_middle);
}

Double3 raised_above_horizon(const Double3& direction) {
  constexpr double min_height = 0x1p-10; // a ninth of the height of the last theta_d: measured at the horizon
  if (direction.z >= min_height) return direction;
  const Double3 level = normalize(Double3(direction.x, direction.y, 0));
  return normalize(Double3(level.x, level.y, min_height));
}

std::span<const BrdfPreset> brdf_presets() {
  return presets;
}

const BrdfPreset* find_brdf_preset(std::string_view name) {
  for (const BrdfPreset& preset : presets)
    if (preset.name == name) return &preset;
  return nullptr;
}

} // namespace refraster
