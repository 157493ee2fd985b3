// Directional albedo over the angle of incidence.

#include "brdf/facts.h"
#include "brdf/page/charts.h"
#include "io/file/text.h"
#include "io/html/scale.h"
#include "io/html/svg.h"

#include <algorithm>

namespace refraster {

std::string albedo_chart(const ShownBrdfs& shown) {
  constexpr double width = 860, height = 380, left = 74, right = 24, bottom = 326;
  const double top = shown.b ? 60 : 36; // below the legend
  // A curve that is looked at needs no more than a thousandth: an eighth of the points of `brdf info`.
  constexpr AlbedoSteps steps{.theta = 360, .phi = 90};
  struct Curve {
    std::vector<double> degrees;
    std::vector<Rgb<double>> albedos;
  };
  std::vector<Curve> curves;
  double greatest = 1;
  for (const Brdf* const brdf : {&shown.a, shown.b}) {
    if (brdf == nullptr) continue;
    Curve& curve = curves.emplace_back();
    for (double degrees = 0; degrees < 90; degrees += degrees < 80 ? 4 : 1) {
      curve.degrees.push_back(degrees);
      curve.albedos.push_back(directional_albedo(*brdf, degrees, steps));
      for (int c = 0; c < 3; ++c) greatest = std::max(greatest, curve.albedos.back()[c]);
    }
  }
  Svg svg(width, height, "Directional albedo over the angle of incidence", brdf_chart_style);
  // A model without bounds at grazing angles must not flatten all that is below 1.
  const Scale y = Scale::around(Scale::Kind::linear, 0, std::min(greatest, 4.0), bottom, top);
  const auto x_of = [&](double degrees) { return left + (width - right - left) * degrees / 90; };
  for (int degrees = 0; degrees <= 90; degrees += 15) {
    svg.line(x_of(degrees), top, x_of(degrees), bottom, "grid");
    svg.text(x_of(degrees), bottom + 16, Anchor::middle, std::to_string(degrees) + "°");
  }
  svg.text((left + width - right) / 2, bottom + 38, Anchor::middle, "light, from the normal", "name");
  svg.y_axis(y, left, width - right, "albedo");
  svg.line(left, y(1), width - right, y(1), "one");
  const char* const colours[] = {"red", "green", "blue"};
  for (std::size_t k = 0; k < curves.size(); ++k)
    for (int c = 0; c < 3; ++c) {
      std::vector<double> xs, ys;
      for (std::size_t i = 0; i < curves[k].degrees.size(); ++i) {
        xs.push_back(x_of(curves[k].degrees[i]));
        ys.push_back(std::max(y(curves[k].albedos[i][c]), top));
      }
      svg.curve(xs, ys, std::string("curve ") + colours[c] + (k == 0 ? "" : " second"));
    }
  double at = left;
  for (const char* const colour : colours) {
    svg.line(at, 17, at + 22, 17, std::string("curve ") + colour);
    svg.text(at + 28, 21, Anchor::start, colour);
    at += 86;
  }
  if (shown.b) draw_pair_legend(svg, at + 20, 17, shown);
  return svg.markup();
}

} // namespace refraster
