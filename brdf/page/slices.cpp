// Image slices over theta_h and theta_d.

#include "brdf/page/charts.h"
#include "brdf/page/colour_map.h"
#include "io/file/text.h"
#include "io/html/svg.h"
#include "io/image/png/png_write.h"
#include "shading/srgb_curve.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace refraster {
namespace {

constexpr int steps = 180; // pixels of a slice on a side: half a bin of theta_d
constexpr double side = 212, gap = 36, left = 64, top = 40, bar_width = 12, bar_gap = 104;

/// Values at the middles of a slice's pixels; row 0 is at theta_d = 90 degrees.
struct Slice {
  std::vector<BrdfValue> values;

  Slice(const Brdf& brdf, double phi_d) : values(std::size_t{steps} * steps) {
#pragma omp parallel for
    for (int y = 0; y < steps; ++y)
      for (int x = 0; x < steps; ++x) {
        const double root = (x + 0.5) / steps;
        values[static_cast<std::size_t>(y * steps + x)] =
            brdf.value(directions_of(HalfDifferenceAngles{root * root * 90, (steps - y - 0.5) / steps * 90, phi_d}));
      }
  }
};

using Paint = std::function<MapColour(std::size_t)>; // of a pixel; no colour: alpha 0

std::string png_of(const Paint& paint) {
  Image<std::uint8_t> image(steps, steps, 4);
  for (std::size_t k = 0; k < std::size_t{steps} * steps; ++k) {
    const MapColour colour = paint(k);
    std::copy(colour.begin(), colour.end(), image.values.begin() + static_cast<std::ptrdiff_t>(4 * k));
  }
  return png_file(image, {});
}

MapColour shown_colour(const BrdfValue& value) {
  if (!value.measured) return {};
  MapColour colour{0, 0, 0, 255};
  for (int c = 0; c < 3; ++c)
    colour[static_cast<std::size_t>(c)] =
        static_cast<std::uint8_t>(std::lround(255 * srgb_encoded(std::clamp(value.f[c] * std::numbers::pi, 0.0, 1.0))));
  return colour;
}

/// Decades of luminance that are shown.
struct Decades {
  double from = -2, to = 0;

  double fraction(double f) const { return f > 0 ? (std::log10(f) - from) / (to - from) : 0; }
};

/// Round powers of ten around all but a hundredth at either end: at the horizon f has hardly a bound.
Decades decades_of(const std::vector<Slice>& slices) {
  std::vector<double> logarithms;
  for (const Slice& slice : slices)
    for (const BrdfValue& value : slice.values)
      if (value.measured && luminance(value.f) > 0) logarithms.push_back(std::log10(luminance(value.f)));
  if (logarithms.empty()) return {};
  const auto at_rank = [&](double rank) {
    const auto place =
        logarithms.begin() + static_cast<std::ptrdiff_t>(rank * static_cast<double>(logarithms.size() - 1));
    std::nth_element(logarithms.begin(), place, logarithms.end());
    return *place;
  };
  Decades decades{std::floor(at_rank(0.01)), std::ceil(at_rank(0.99))};
  if (decades.from == decades.to) --decades.from;
  return decades;
}

void draw_axes(Svg& svg, double x, double y) {
  svg.rectangle(x, y, side, side, "panel");
  for (const int degrees : {1, 5, 15, 30, 60, 90}) {
    const double at = x + side * std::sqrt(degrees / 90.0);
    svg.line(at, y + side, at, y + side + 4, "one");
    svg.text(at, y + side + 15, Anchor::middle, std::to_string(degrees) + "°", "tick");
  }
  for (const int degrees : {0, 30, 60, 90}) {
    const double at = y + side * (1 - degrees / 90.0);
    svg.line(x - 4, at, x, at, "one");
    svg.text(x - 7, at + 4, Anchor::end, std::to_string(degrees) + "°", "tick");
  }
  svg.text(x + side / 2, y + side + 31, Anchor::middle, "θh", "name");
}

void draw_bar(Svg& svg, double x, double y, const std::string& png,
              const std::vector<std::pair<double, std::string>>& marks) {
  svg.image(x, y, bar_width, side, png);
  svg.rectangle(x, y, bar_width, side, "panel");
  for (const auto& [fraction, words] : marks) {
    const double at = y + side * (1 - fraction);
    svg.line(x + bar_width, at, x + bar_width + 4, at, "one");
    svg.text(x + bar_width + 7, at + 4, Anchor::start, words, "tick");
  }
}

std::string decade_text(int decade) {
  return decade >= -3 && decade <= 4 ? format("%g", std::pow(10, decade)) : format("1e%d", decade);
}

void draw_decades_bar(Svg& svg, double x, double y, const Decades& decades) {
  std::vector<std::pair<double, std::string>> marks;
  for (double decade = decades.from; decade <= decades.to; ++decade)
    marks.emplace_back((decade - decades.from) / (decades.to - decades.from), decade_text(static_cast<int>(decade)));
  draw_bar(svg, x, y, png_file(colour_strip(sequential_colour, 0, 1), {}), marks);
  svg.text(x + bar_width / 2, y - 8, Anchor::middle, "f, 1/sr", "tick");
}

/// log2 of b over a, from -3 to 3.
constexpr double max_stops = 3;

MapColour ratio_colour(const BrdfValue& a, const BrdfValue& b) {
  const double f = luminance(a.f), g = luminance(b.f);
  if (!a.measured || !b.measured || (f == 0 && g == 0)) return {};
  return diverging_colour(std::log2(g / f) / max_stops);
}

void draw_ratio_bar(Svg& svg, double x, double y) {
  draw_bar(svg, x, y, png_file(colour_strip(diverging_colour, -1, 1), {}),
           {{0, "⅛"}, {1. / 6, "¼"}, {2. / 6, "½"}, {0.5, "1"}, {4. / 6, "2"}, {5. / 6, "4"}, {1, "8"}});
  svg.text(x + bar_width / 2, y - 8, Anchor::middle, "b / a", "tick");
}

struct SliceKind {
  double phi_d;
  const char* words;
  bool as_colour;
};
constexpr SliceKind kinds[] = {{90, "as a colour, f π; φd = 90°", true},
                               {90, "luminance; φd = 90°", false},
                               {0, "luminance, plane of incidence; φd = 0°", false}};
constexpr double row_height = side + 84;

/// Of one reflectance the kinds are columns, of two they are rows.
struct Layout {
  bool two;

  double x(std::size_t kind, std::size_t which) const {
    const double column = side + gap;
    if (two) return left + static_cast<double>(which) * column;
    return left + static_cast<double>(kind) * column + (kind == 2 ? bar_gap - gap : 0);
  }
  double y(std::size_t kind) const { return two ? top + static_cast<double>(kind) * row_height : top; }
  double bar_x(std::size_t kind) const { return x(kind, two ? 1 : 0) + side + 14; }
  double ratio_x() const { return x(0, 1) + side + bar_gap + 24; }
  double width() const { return two ? ratio_x() + side + 60 : bar_x(2) + 60; }
  double height() const { return two ? top + 3 * row_height : top + row_height; }
};

} // namespace

std::string slices_chart(const ShownBrdfs& shown) {
  const Layout layout{shown.b != nullptr};
  std::vector<Slice> slices; // a of 90 and 0 degrees, then b
  for (const Brdf* const brdf : {&shown.a, shown.b})
    for (const double phi_d : {90.0, 0.0})
      if (brdf != nullptr) slices.emplace_back(*brdf, phi_d);
  const Decades decades = decades_of(slices);
  Svg svg(layout.width(), layout.height(), "Slices of reflectance over the half and difference angles",
          brdf_chart_style);
  for (std::size_t kind = 0; kind < std::size(kinds); ++kind) {
    const double y = layout.y(kind);
    const std::size_t of_phi = kinds[kind].phi_d == 90 ? 0 : 1;
    for (std::size_t which = 0; which < (layout.two ? 2u : 1u); ++which) {
      const Slice& slice = slices[2 * which + of_phi];
      const double x = layout.x(kind, which);
      svg.image(x, y, side, side, png_of([&](std::size_t at) -> MapColour {
                  const BrdfValue& value = slice.values[at];
                  if (kinds[kind].as_colour) return shown_colour(value);
                  return value.measured ? sequential_colour(decades.fraction(luminance(value.f))) : MapColour{};
                }));
      draw_axes(svg, x, y);
      svg.text(x, y - 9, Anchor::start, layout.two || kind == 0 ? short_label(which == 0 ? shown.a : *shown.b) : "",
               "title");
      svg.text(x, y + side + 48, Anchor::start, which == 0 ? kinds[kind].words : "", "note");
    }
    if (layout.two || kind == 0) svg.upward_text(18, y + side / 2, "θd");
    if (kinds[kind].as_colour) continue;
    draw_decades_bar(svg, layout.bar_x(kind), y, decades);
    if (!layout.two) continue;
    svg.image(layout.ratio_x(), y, side, side, png_of([&](std::size_t at) {
                return ratio_colour(slices[of_phi].values[at], slices[2 + of_phi].values[at]);
              }));
    draw_axes(svg, layout.ratio_x(), y);
    svg.text(layout.ratio_x(), y - 9, Anchor::start, "b over a", "title");
    draw_ratio_bar(svg, layout.ratio_x() + side + 14, y);
  }
  return svg.markup();
}

} // namespace refraster
