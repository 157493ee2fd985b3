// Polar lobes in the plane of incidence.

#include "brdf/page/charts.h"
#include "io/file/text.h"
#include "io/html/svg.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace refraster {
namespace {

constexpr double incidences[] = {10, 35, 55, 75}; // degrees
constexpr double width = 860, radius = 350, centre_x = width / 2, centre_y = 412, height = 470;
constexpr double step = 0.25; // degrees: a lobe of roughness 0.02 is four of them wide

/// theta_out from -90 (the light's side) to 90 degrees, and luminance there.
struct PolarLobe {
  std::size_t series, which;
  std::vector<double> degrees, values;
};

PolarLobe lobe_of(const Brdf& brdf, std::size_t series, std::size_t which) {
  PolarLobe lobe{series, which, {}, {}};
  for (double theta = -89.75; theta < 90; theta += step) {
    const BrdfValue value =
        brdf.value(directions_of(InOutAngles{incidences[series], std::abs(theta), theta < 0 ? 0.0 : 180.0}));
    if (!value.measured) continue;
    lobe.degrees.push_back(theta);
    lobe.values.push_back(luminance(value.f));
  }
  return lobe;
}

struct Polar {
  double from, to; // decades at the centre and at the rim

  double distance(double f) const {
    if (!(f > 0)) return 0;
    return radius * std::clamp((std::log10(f) - from) / (to - from), 0.0, 1.0);
  }
};

double x_at(double degrees, double distance) {
  return centre_x + distance * std::sin(degrees * std::numbers::pi / 180);
}
double y_at(double degrees, double distance) {
  return centre_y - distance * std::cos(degrees * std::numbers::pi / 180);
}

std::string path_of(const PolarLobe& lobe, const Polar& polar) {
  std::string data = format("M%.1f %.1f", centre_x, centre_y);
  for (std::size_t k = 0; k < lobe.degrees.size(); ++k) {
    const double distance = polar.distance(lobe.values[k]);
    data += format("L%.1f %.1f", x_at(lobe.degrees[k], distance), y_at(lobe.degrees[k], distance));
  }
  return data + "Z";
}

void draw_grid(Svg& svg, const Polar& polar) {
  for (double decade = polar.from + 1; decade <= polar.to; ++decade) {
    const double r = radius * (decade - polar.from) / (polar.to - polar.from);
    svg.path(format("M%.1f %.1fA%.1f %.1f 0 0 1 %.1f %.1f", centre_x - r, centre_y, r, r, centre_x + r, centre_y),
             "grid ring");
    for (const double side : {-1.0, 1.0})
      svg.text(centre_x + side * r, centre_y + 15, Anchor::middle, format("%g", std::pow(10, decade)), "tick");
  }
  for (int degrees = -90; degrees <= 90; degrees += 15) {
    svg.line(centre_x, centre_y, x_at(degrees, radius), y_at(degrees, radius), "grid");
    if (degrees % 30 == 0)
      svg.text(x_at(degrees, radius + 26), y_at(degrees, radius + 26) + 4, Anchor::middle,
               std::to_string(std::abs(degrees)) + "°", "tick");
  }
  svg.line(centre_x - radius, centre_y, centre_x + radius, centre_y, "one");
  svg.text(centre_x, centre_y + 34, Anchor::middle, "luminance of f, 1/sr", "name");
}

} // namespace

std::string lobes_chart(const ShownBrdfs& shown) {
  std::vector<PolarLobe> lobes;
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  for (std::size_t series = 0; series < std::size(incidences); ++series)
    for (std::size_t which = 0; which < (shown.b ? 2u : 1u); ++which) {
      lobes.push_back(lobe_of(which == 0 ? shown.a : *shown.b, series, which));
      // At the horizon f has hardly a bound, or is hardly there.
      for (std::size_t k = 0; k < lobes.back().values.size(); ++k)
        if (const double value = lobes.back().values[k]; value > 0 && std::abs(lobes.back().degrees[k]) < 80)
          least = std::min(least, value), greatest = std::max(greatest, value);
    }
  if (greatest == 0) least = 0.1, greatest = 1;
  Polar polar{std::floor(std::log10(least)) - 1, std::ceil(std::log10(greatest))};
  polar.from = std::max(polar.from, polar.to - 5); // what is darker is not seen beside it
  Svg svg(width, height, "Lobes in the plane of incidence", brdf_chart_style);
  draw_grid(svg, polar);
  for (const PolarLobe& lobe : lobes)
    svg.path(path_of(lobe, polar), format("lobe series%zu%s", lobe.series, lobe.which == 0 ? "" : " second"));
  for (std::size_t series = 0; series < std::size(incidences); ++series) {
    const double from = -incidences[series];
    svg.line(x_at(from, radius - 14), y_at(from, radius - 14), x_at(from, radius + 14), y_at(from, radius + 14),
             format("curve series%zu", series));
    const double y = 22 + 20 * static_cast<double>(series);
    svg.line(16, y - 4, 38, y - 4, format("curve series%zu", series));
    svg.text(44, y, Anchor::start, format("light at %g°", incidences[series]));
  }
  if (shown.b) draw_pair_legend(svg, width - 290, 18, shown);
  return svg.markup();
}

} // namespace refraster
