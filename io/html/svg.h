#pragma once
// A picture: in a page it takes the page's colours, on light and on dark paper; saved as a file it stands alone, with
// its own style, on light paper. Everything is drawn by classes of chart_style.h.

#include "io/html/scale.h"

#include <span>
#include <string>
#include <string_view>

namespace refraster {

enum class Anchor { start, middle, end };

/// What a colour stands for, in a legend.
struct LegendEntry {
  std::string classes, words;
};

class Svg {
public:
  /// `title` is read to those who do not see the picture. further_style: of classes that chart_style.h has not.
  Svg(double width, double height, const std::string& title, std::string_view further_style = {});

  void line(double x1, double y1, double x2, double y2, std::string_view classes);
  void rectangle(double x, double y, double width, double height, std::string_view classes,
                 const std::string& tooltip = {});
  void dot(double x, double y, double radius, std::string_view classes, const std::string& tooltip = {});
  /// Through points x[i], y[i].
  void curve(std::span<const double> x, std::span<const double> y, std::string_view classes);
  /// Along `data`, in SVG's own words: "M 0 0 L 10 10".
  void path(const std::string& data, std::string_view classes);
  /// An image, its bytes those of a PNG file.
  void image(double x, double y, double width, double height, const std::string& png, const std::string& tooltip = {});
  void text(double x, double y, Anchor anchor, const std::string& words, std::string_view classes = {});
  /// A row of coloured marks and what they stand for, from x to the right; y is the middle of the row.
  void legend(double x, double y, std::span<const LegendEntry> entries);
  /// Upwards, for the name of a vertical axis.
  void upward_text(double x, double y, const std::string& words);

  /// Lines of a grid with numbers below (x) or to the left (y), and the axis's name.
  void x_axis(const Scale& scale, double top, double bottom, const std::string& name);
  void y_axis(const Scale& scale, double left, double right, const std::string& name);

  std::string markup() const { return svg_ + "</svg>\n"; }

private:
  std::string svg_;
};

} // namespace refraster
