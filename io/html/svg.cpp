#include "io/html/svg.h"

#include "io/file/text.h"
#include "io/html/base64.h"
#include "io/html/chart_style.h"
#include "io/html/markup.h"

namespace refraster {
namespace {

std::string classes_attribute(std::string_view classes) {
  return classes.empty() ? "" : " class=\"" + std::string(classes) + "\"";
}

/// Closes an element that may have a tooltip.
std::string closed(const char* element, const std::string& tooltip) {
  return tooltip.empty() ? "/>\n" : "><title>" + escaped(tooltip) + "</title></" + element + ">\n";
}

} // namespace

Svg::Svg(double width, double height, const std::string& title, std::string_view further_style) {
  svg_ =
      format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %g %g\" width=\"%g\" height=\"%g\" role=\"img\" "
             "aria-label=\"",
             width, height, width, height) +
      escaped(title) + "\">\n<style>" + chart_style + std::string(further_style) + "</style>\n";
  rectangle(0, 0, width, height, "paper");
}

void Svg::line(double x1, double y1, double x2, double y2, std::string_view classes) {
  svg_ += format("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\"", x1, y1, x2, y2) + classes_attribute(classes) +
          "/>\n";
}

void Svg::rectangle(double x, double y, double width, double height, std::string_view classes,
                    const std::string& tooltip) {
  svg_ += format("<rect x=\"%.2f\" y=\"%.1f\" width=\"%.2f\" height=\"%.1f\"", x, y, width, height) +
          classes_attribute(classes) + closed("rect", tooltip);
}

void Svg::dot(double x, double y, double radius, std::string_view classes, const std::string& tooltip) {
  svg_ += format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\"", x, y, radius) + classes_attribute(classes) +
          closed("circle", tooltip);
}

void Svg::curve(std::span<const double> x, std::span<const double> y, std::string_view classes) {
  svg_ += "<polyline points=\"";
  for (std::size_t i = 0; i < x.size(); ++i) svg_ += format("%s%.1f,%.1f", i == 0 ? "" : " ", x[i], y[i]);
  svg_ += "\"" + classes_attribute(classes) + "/>\n";
}

void Svg::path(const std::string& data, std::string_view classes) {
  svg_ += "<path d=\"" + data + "\"" + classes_attribute(classes) + "/>\n";
}

void Svg::image(double x, double y, double width, double height, const std::string& png, const std::string& tooltip) {
  svg_ += format("<image x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"%.2f\" preserveAspectRatio=\"none\" "
                 "href=\"data:image/png;base64,",
                 x, y, width, height) +
          base64({png.begin(), png.end()}) + "\"" + closed("image", tooltip);
}

void Svg::text(double x, double y, Anchor anchor, const std::string& words, std::string_view classes) {
  const char* const names[] = {"start", "middle", "end"};
  svg_ += format("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\"", x, y, names[static_cast<int>(anchor)]) +
          classes_attribute(classes) + ">" + escaped(words) + "</text>\n";
}

void Svg::legend(double x, double y, std::span<const LegendEntry> entries) {
  constexpr double mark = 11, gap = 6, between = 16;
  constexpr double character = 6.6; // pixels, a mean of sans serif at 12 pixels
  for (const LegendEntry& entry : entries) {
    rectangle(x, y - mark / 2, mark, mark, "mark " + entry.classes);
    text(x + mark + gap, y + 4, Anchor::start, entry.words);
    x += mark + gap + character * static_cast<double>(entry.words.size()) + between;
  }
}

void Svg::upward_text(double x, double y, const std::string& words) {
  svg_ += format("<text transform=\"translate(%.1f %.1f) rotate(-90)\" text-anchor=\"middle\" class=\"name\">", x, y) +
          escaped(words) + "</text>\n";
}

void Svg::x_axis(const Scale& scale, double top, double bottom, const std::string& name) {
  for (const Tick& tick : scale.ticks()) {
    line(scale(tick.value), top, scale(tick.value), bottom, "grid");
    text(scale(tick.value), bottom + 16, Anchor::middle, tick.label);
  }
  text((scale(scale.from()) + scale(scale.to())) / 2, bottom + 36, Anchor::middle, name, "name");
}

void Svg::y_axis(const Scale& scale, double left, double right, const std::string& name) {
  for (const Tick& tick : scale.ticks()) {
    line(left, scale(tick.value), right, scale(tick.value), "grid");
    text(left - 7, scale(tick.value) + 4, Anchor::end, tick.label);
  }
  upward_text(14, (scale(scale.from()) + scale(scale.to())) / 2, name);
}

} // namespace refraster
