// Luminance over theta_h.

#include "brdf/page/charts.h"
#include "io/file/text.h"
#include "io/html/scale.h"
#include "io/html/svg.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace refraster {
namespace {

constexpr double theta_ds[] = {5, 45, 75}; // degrees
constexpr int points = 400;

struct ProfileCurve {
  std::size_t series, which;         // of theta_ds; 0: a, 1: b
  std::vector<double> roots, values; // sqrt(theta_h / 90 degrees); luminance, > 0
};

ProfileCurve curve_of(const Brdf& brdf, std::size_t series, std::size_t which) {
  ProfileCurve curve{series, which, {}, {}};
  for (int k = 0; k <= points; ++k) {
    const double root = k / double{points};
    // Just above the horizon at the right end.
    const HalfDifferenceAngles angles{std::min(root * root * 90, 89.99), theta_ds[series], 90};
    const BrdfValue value = brdf.value(directions_of(angles));
    if (!value.measured || !(luminance(value.f) > 0)) continue;
    curve.roots.push_back(root);
    curve.values.push_back(luminance(value.f));
  }
  return curve;
}

} // namespace

std::string profile_chart(const ShownBrdfs& shown) {
  constexpr double width = 860, height = 400, left = 74, right = 24, bottom = 346;
  const double top = shown.b ? 60 : 36; // below the legend
  std::vector<ProfileCurve> curves;
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  for (std::size_t series = 0; series < std::size(theta_ds); ++series)
    for (std::size_t which = 0; which < (shown.b ? 2u : 1u); ++which) {
      curves.push_back(curve_of(which == 0 ? shown.a : *shown.b, series, which));
      for (const double value : curves.back().values)
        least = std::min(least, value), greatest = std::max(greatest, value);
    }
  if (greatest == 0) least = 1e-3, greatest = 1;
  const Scale y = Scale::around(Scale::Kind::logarithmic, std::max(least, greatest * 1e-7), greatest, bottom, top);
  Svg svg(width, height, "Luminance over the half angle", brdf_chart_style);
  const auto x_of = [&](double root) { return left + (width - left - right) * root; };
  for (const int degrees : {0, 1, 2, 5, 10, 20, 30, 45, 60, 90}) {
    const double x = x_of(std::sqrt(degrees / 90.0));
    svg.line(x, top, x, bottom, "grid");
    svg.text(x, bottom + 16, Anchor::middle, std::to_string(degrees) + "°");
  }
  svg.text((left + width - right) / 2, bottom + 38, Anchor::middle, "θh, spaced by its root; φd = 90°", "name");
  svg.y_axis(y, left, width - right, "luminance of f, 1/sr");
  for (const ProfileCurve& curve : curves) {
    std::vector<double> xs, ys;
    for (std::size_t k = 0; k < curve.roots.size(); ++k) {
      xs.push_back(x_of(curve.roots[k]));
      ys.push_back(std::clamp(y(curve.values[k]), top, bottom));
    }
    svg.curve(xs, ys, format("curve series%zu%s", curve.series, curve.which == 0 ? "" : " second"));
  }
  double x = left;
  for (std::size_t series = 0; series < std::size(theta_ds); ++series, x += 96) {
    svg.line(x, 17, x + 22, 17, format("curve series%zu", series));
    svg.text(x + 28, 21, Anchor::start, format("θd = %g°", theta_ds[series]));
  }
  if (shown.b) draw_pair_legend(svg, x + 20, 17, shown);
  return svg.markup();
}

} // namespace refraster
