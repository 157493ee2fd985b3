#include "bench/page/charts.h"

#include "bench/report/report_text.h"
#include "io/file/text.h"

#include <algorithm>

namespace refraster::bench {
namespace {

std::vector<LegendEntry> part_legend() {
  std::vector<LegendEntry> legend;
  for (const auto& [name, part] : split_parts) {
    std::string words = name;
    std::replace(words.begin(), words.end(), '_', ' ');
    legend.push_back({"part" + std::to_string(legend.size()), words});
  }
  return legend;
}

} // namespace

std::string split_chart(const SceneResult& scene) {
  constexpr double width = 860, left = 120, right = 60, bar = 20, gap = 8, top = 28;
  const auto rows = static_cast<double>(scene.precisions.size());
  const double bottom = top + rows * (bar + gap), height = bottom + 44;
  const auto total = [](const PrecisionResult& precision) {
    double sum = 0;
    for (const auto& [name, part] : split_parts) sum += std::max(precision.split_ns.*part, 0.0);
    return sum;
  };
  double most = 0;
  for (const PrecisionResult& precision : scene.precisions) most = std::max(most, total(precision));
  const Scale x = Scale::around(Scale::Kind::linear, 0, most, left, width - right);
  Svg svg(width, height, "Nanoseconds a shaded pixel by part of the frame, " + scene.scene);
  svg.legend(left, 12, part_legend());
  svg.x_axis(x, top, bottom, "ns a shaded pixel, wall time");
  double y = top + gap / 2;
  for (const PrecisionResult& precision : scene.precisions) {
    const std::string name =
        precision.precision + format(", %d thread%s", precision.threads, precision.threads == 1 ? "" : "s");
    svg.text(left - 8, y + bar * 0.7, Anchor::end, name);
    double at = 0;
    int number = 0;
    for (const auto& [part_name, part] : split_parts) {
      const double ns = std::max(precision.split_ns.*part, 0.0);
      svg.rectangle(x(at), y, x(at + ns) - x(at), bar, "part" + std::to_string(number++),
                    std::string(part_name) + ": " + part_text(precision, part) + " ns");
      at += ns;
    }
    svg.text(x(at) + 6, y + bar * 0.7, Anchor::start, three_digits(at), "strong");
    y += bar + gap;
  }
  return svg.markup();
}

} // namespace refraster::bench
