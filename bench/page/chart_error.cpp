#include "bench/page/charts.h"

#include "io/html/svg.h"
#include "io/file/text.h"

#include <algorithm>
#include <limits>

namespace refraster::bench {
namespace {

struct Place {
  std::size_t scene, precision;
  double ns, error;
  std::string tooltip;
};

/// With the first number of threads of each scene.
std::vector<Place> places(const Run& run) {
  const std::vector<std::string> precisions = precisions_of(run);
  std::vector<Place> all;
  for (std::size_t s = 0; s < run.scenes.size(); ++s) {
    const SceneResult& scene = run.scenes[s];
    for (const PrecisionResult& result : scene.precisions) {
      if (result.threads != scene.precisions.front().threads) continue;
      const auto error = std::find_if(scene.errors.begin(), scene.errors.end(),
                                      [&](const PrecisionError& e) { return e.precision == result.precision; });
      if (error == scene.errors.end() || error->against_exact.pixels == 0) continue;
      const double ns = result.frame_ms.median * 1e6 / scene.shaded(), mean = error->against_exact.mean_relative;
      if (!(mean > 0 && ns < std::numeric_limits<double>::infinity())) continue; // nothing that has a logarithm
      all.push_back({s, index_of(precisions, result.precision), ns, mean,
                     format("%s, %s: %.3g ns, %.2g", label(run, scene).c_str(), result.precision.c_str(), ns, mean)});
    }
  }
  return all;
}

} // namespace

std::string error_chart(const Run& run) {
  const std::vector<Place> all = places(run);
  if (all.empty()) return {};
  constexpr double width = 860, height = 450, left = 74, right = 20, top = 34, bottom = 394;
  double min_ns = all[0].ns, max_ns = all[0].ns, least = all[0].error, most = all[0].error;
  for (const Place& p : all) {
    min_ns = std::min(min_ns, p.ns), max_ns = std::max(max_ns, p.ns);
    least = std::min(least, p.error), most = std::max(most, p.error);
  }
  const Scale x = Scale::around(Scale::Kind::logarithmic, min_ns / 1.1, max_ns * 1.1, left, width - right);
  const Scale y = Scale::around(Scale::Kind::logarithmic, least / 2, most * 2, bottom, top);
  Svg svg(width, height, "Mean relative error against nanoseconds a shaded pixel");
  svg.legend(left, 14, precision_legend(run));
  svg.x_axis(x, top, bottom, "ns a shaded pixel, wall time");
  svg.y_axis(y, left, width - right, "mean relative error");
  for (std::size_t s = 0; s < run.scenes.size(); ++s) {
    std::vector<double> xs, ys;
    for (const Place& p : all)
      if (p.scene == s) xs.push_back(x(p.ns)), ys.push_back(y(p.error));
    if (!xs.empty()) svg.curve(xs, ys, "joined");
  }
  for (const Place& p : all) {
    svg.dot(x(p.ns), y(p.error), 6, precision_class(p.precision), p.tooltip);
    if (run.scenes.size() > 1) svg.text(x(p.ns), y(p.error) - 10, Anchor::middle, std::to_string(p.scene + 1), "small");
  }
  return svg.markup();
}

} // namespace refraster::bench
