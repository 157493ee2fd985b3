#include "bench/page/charts.h"

#include "io/file/text.h"

#include <algorithm>

namespace refraster::bench {

std::vector<std::string> precisions_of(const Run& run) {
  std::vector<std::string> precisions;
  const auto add = [&](const std::string& precision) {
    if (std::find(precisions.begin(), precisions.end(), precision) == precisions.end()) precisions.push_back(precision);
  };
  for (const SceneResult& scene : run.scenes)
    for (const PrecisionResult& result : scene.precisions) add(result.precision);
  for (const ScalingCurve& curve : run.scaling) add(curve.precision);
  return precisions;
}

std::size_t index_of(const std::vector<std::string>& precisions, const std::string& precision) {
  return static_cast<std::size_t>(std::find(precisions.begin(), precisions.end(), precision) - precisions.begin());
}

std::string precision_class(std::size_t n) {
  return "precision" + std::to_string(n % 4);
}

std::vector<LegendEntry> precision_legend(const Run& run) {
  std::vector<LegendEntry> legend;
  for (const std::string& precision : precisions_of(run)) legend.push_back({precision_class(legend.size()), precision});
  return legend;
}

std::string short_name(const SceneResult& scene) {
  const std::size_t folder = scene.scene.rfind('/');
  const std::string name = folder == std::string::npos ? scene.scene : scene.scene.substr(folder + 1);
  return name.ends_with(".json") ? name.substr(0, name.size() - 5) : name;
}

std::string label(const Run& run, const SceneResult& scene) {
  const bool several = std::any_of(run.scenes.begin(), run.scenes.end(), [&](const SceneResult& other) {
    return other.width != scene.width || other.height != scene.height;
  });
  return several ? short_name(scene) + format(", %d × %d", scene.width, scene.height) : short_name(scene);
}

} // namespace refraster::bench
