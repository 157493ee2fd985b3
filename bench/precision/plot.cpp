#include "bench/precision/plot.h"

#include <cmath>
#include <cstdio>
#include <initializer_list>

namespace refraster::precision {

namespace {

constexpr double width = 760, height = 440, left = 76, right = 20, top = 42, bottom = 56;

/// One logarithmic axis: decades from..to over pixels a..b.
struct Axis {
  double from, to, a, b;
  double operator()(double decade) const { return a + (b - a) * (decade - from) / (to - from); }
};
constexpr Axis x_axis{-8, 0, left, width - right};
constexpr Axis y_axis{-7, 1, height - bottom, top};

std::string format(const char* pattern, auto... values) {
  char buffer[400];
  std::snprintf(buffer, sizeof buffer, pattern, values...);
  return buffer;
}

std::string line(double x1, double y1, double x2, double y2, const char* style) {
  return format("<path d=\"M%.1f %.1fL%.1f %.1f\" %s/>\n", x1, y1, x2, y2, style);
}

std::string label(double x, double y, const char* anchor, const char* colour, const std::string& what) {
  return format("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" fill=\"%s\">", x, y, anchor, colour) + what +
         "</text>\n";
}

/// 10 to the n-th.
std::string power_of_ten(int n) {
  if (n == 0 || n == 1) return n == 0 ? "1" : "10";
  return format("10<tspan dy=\"-5\" font-size=\"10\">%s%d</tspan>", n < 0 ? "−" : "", std::abs(n));
}

std::string curve(std::span<const HighlightPoint> points, double HighlightPoint::*error, const char* style) {
  std::string path;
  for (const HighlightPoint& point : points) {
    const double decade = std::fmax(std::log10(point.*error), y_axis.from); // an error of 0 lies on the border
    path += format("%c%.1f %.1f", path.empty() ? 'M' : 'L', x_axis(std::log10(point.angle)), y_axis(decade));
  }
  return "<path d=\"" + path + "\" " + style + "/>\n";
}

} // namespace

std::string highlight_plot(std::span<const HighlightPoint> points) {
  std::string svg = format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %g %g\" width=\"%g\" height=\"%g\" "
                           "font-family=\"sans-serif\" font-size=\"13\">\n",
                           width, height, width, height);
  svg += "<title>Error of the MERL coordinate u in float near a highlight</title>\n";
  svg += "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n<g fill=\"none\" stroke-linejoin=\"round\">\n";
  const char* const grid = "stroke=\"#ddd\"";
  for (int decade = -8; decade <= 0; ++decade) svg += line(x_axis(decade), y_axis.a, x_axis(decade), y_axis.b, grid);
  for (int decade = -7; decade <= 1; ++decade) svg += line(x_axis.a, y_axis(decade), x_axis.b, y_axis(decade), grid);
  svg += line(x_axis.a, y_axis(0), x_axis.b, y_axis(0), "stroke=\"#888\"");
  // The first bin's end: u = 1.
  const double first_bin = std::log10(std::acos(-1.0) / 2 / (90.0 * 90.0));
  svg += line(x_axis(first_bin), y_axis.a, x_axis(first_bin), y_axis.b, "stroke=\"#888\" stroke-dasharray=\"2 4\"");
  svg +=
      curve(points, &HighlightPoint::acos_median, "stroke=\"#d55e00\" stroke-width=\"1.5\" stroke-dasharray=\"5 4\"");
  svg +=
      curve(points, &HighlightPoint::closed_median, "stroke=\"#0072b2\" stroke-width=\"1.5\" stroke-dasharray=\"5 4\"");
  svg += curve(points, &HighlightPoint::acos_max, "stroke=\"#d55e00\" stroke-width=\"2.5\"");
  svg += curve(points, &HighlightPoint::closed_max, "stroke=\"#0072b2\" stroke-width=\"2.5\"");
  svg += "</g>\n";
  for (int decade = -8; decade <= 0; ++decade)
    svg += label(x_axis(decade), y_axis.a + 20, "middle", "#333", power_of_ten(decade));
  for (int decade = -7; decade <= 1; ++decade)
    svg += label(x_axis.a - 8, y_axis(decade) + 5, "end", "#333", power_of_ten(decade));
  svg += label((x_axis.a + x_axis.b) / 2, height - 12, "middle", "#333",
               "angle θh from the normal to the half vector, radians");
  svg += format("<text transform=\"translate(20 %.1f) rotate(-90)\" text-anchor=\"middle\" fill=\"#333\">error of u, "
                "bins</text>\n",
                (y_axis.a + y_axis.b) / 2);
  svg += label(x_axis.a, 24, "start", "#333", "MERL coordinate u in float: largest (solid) and median (dashed) error");
  svg += label(x_axis(first_bin) + 6, y_axis(-6.8) + 4, "start", "#666", "first bin ends");
  svg += label(x_axis(-6.9), y_axis(-0.95), "start", "#d55e00", "acos(n·h)");
  svg += label(x_axis(-7.8), y_axis(-4.4), "start", "#0072b2", "closed form: atan2(|n × s|, n·s)");
  return svg + "</svg>\n";
}

} // namespace refraster::precision
