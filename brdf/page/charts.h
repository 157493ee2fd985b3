#pragma once
// The pictures of a reflectance, or of two, each an SVG element that also stands alone as a file.

#include "brdf/brdf.h"

#include "io/html/svg.h"

#include <string>
#include <string_view>
#include <vector>

namespace refraster {

/// What is shown: one, or two beside each other.
struct ShownBrdfs {
  const Brdf& a;
  const Brdf* b = nullptr;
};

/// Image slices over theta_h, spaced by its root as a table is, and theta_d, of phi_d = 90 and 0 degrees: as a colour,
/// f pi, in which a white Lambert surface is white; and its luminance in false colours on a scale of logarithms. Of two
/// also how many times as bright the second is. Burley, "Physically based shading at Disney", 2012, section 3.
std::string slices_chart(const ShownBrdfs& shown);

/// Luminance of f over theta_h, on a scale of logarithms, at three theta_d.
std::string profile_chart(const ShownBrdfs& shown);

/// Luminance of f toward the eye in the plane of incidence, as a polar plot on a scale of logarithms, of light from
/// several angles.
std::string lobes_chart(const ShownBrdfs& shown);

/// Directional albedo over the angle of incidence, by channel.
std::string albedo_chart(const ShownBrdfs& shown);

/// A picture and the name of its file.
struct BrdfChart {
  std::string_view name, title, about;
  std::string (*chart)(const ShownBrdfs&);
};
extern const std::vector<BrdfChart> brdf_charts;

/// Classes of the pictures beside those of io/html/chart_style.h.
extern const std::string_view brdf_chart_style;

/// Which lines are of a, and which of b, from x to the right; y is the middle of the row.
void draw_pair_legend(Svg& svg, double x, double y, const ShownBrdfs& shown);

/// "brass.binary" of a path; of a long name its beginning.
std::string short_label(const Brdf& brdf);

} // namespace refraster
