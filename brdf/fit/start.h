#pragma once
// Where a fit begins: closed forms of a highlight's height and width.

#include "brdf/brdf.h"

#include <optional>
#include <string_view>
#include <vector>

namespace refraster {

/// A reflectance along theta_h, at theta_d = 22.5 degrees and phi_d = 90, where light and eye stand equally high.
struct HighlightShape {
  Rgb<double> diffuse{0};  // the least f of each channel up to theta_h = 60 degrees
  Rgb<double> specular{0}; // f at the smallest theta_h, less that
  double half_width = 0.1; // radians: theta_h where the luminance of the highlight has fallen to a half, or the widest
  double cos_theta_d = 1;
};

/// Nothing where it is measured nowhere along that line.
std::optional<HighlightShape> highlight_shape(const Brdf& brdf);

/// Lobes with the height and width of the highlight, times `width`; further ones three times as wide each, and a third
/// as high.
using FitStart = std::vector<BrdfModel> (*)(const HighlightShape& shape, int lobes, double width);

/// A model that fits may have.
struct FittedModel {
  std::string_view name;
  std::vector<FitStart> starts; // one at least: each is tried
};

/// The list, in the order of help.
extern const std::vector<FittedModel> fitted_models;

/// Null if there is none of that name.
const FittedModel* find_fitted_model(std::string_view name);

} // namespace refraster
