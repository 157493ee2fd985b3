#include "bench/page/charts.h"

#include "io/html/svg.h"
#include "io/file/text.h"

#include <algorithm>

namespace refraster::bench {

std::string ratio_chart(const Run& run) {
  const std::vector<std::string> precisions = precisions_of(run);
  struct Row {
    std::string name;
    std::vector<const PrecisionResult*> results;
  };
  std::vector<Row> rows; // a scene and a number of threads
  double least = 1, most = 1;
  for (const SceneResult& scene : run.scenes)
    for (const OpenGlResult& opengl : scene.opengl) {
      Row& row = rows.emplace_back();
      row.name = label(run, scene) + format(", %d thread%s", opengl.threads, opengl.threads == 1 ? "" : "s");
      for (const PrecisionResult& precision : scene.precisions) {
        if (precision.threads != opengl.threads || !precision.opengl_ratio) continue;
        row.results.push_back(&precision);
        least = std::min(least, precision.opengl_ratio->lower), most = std::max(most, precision.opengl_ratio->upper);
      }
    }
  if (rows.empty()) return {};

  constexpr double width = 860, left = 250, right = 30, line = 26, top = 28;
  const double bottom = top + static_cast<double>(rows.size()) * line, height = bottom + 44;
  const Scale x = Scale::around(Scale::Kind::logarithmic, least, most, left, width - right);
  Svg svg(width, height, "How many times as long OpenGL takes");
  svg.legend(left, 12, precision_legend(run));
  svg.x_axis(x, top, bottom, "time of OpenGL over time of refraster; to the right of 1 refraster is faster");
  svg.line(x(1), top, x(1), bottom, "one");
  double y = top + line / 2;
  for (const Row& row : rows) {
    svg.text(left - 12, y + 4, Anchor::end, row.name);
    for (const PrecisionResult* const precision : row.results) {
      const std::string colour = precision_class(index_of(precisions, precision->precision));
      const Spread& ratio = *precision->opengl_ratio;
      svg.line(x(ratio.lower), y, x(ratio.upper), y, "range " + colour);
      svg.dot(x(ratio.median), y, 5.5, colour,
              format("%s: %.2f, half of the repetitions %.2f to %.2f", precision->precision.c_str(), ratio.median,
                     ratio.lower, ratio.upper));
    }
    y += line;
  }
  return svg.markup();
}

} // namespace refraster::bench
