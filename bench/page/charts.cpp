#include "bench/page/charts.h"

#include "bench/report/format.h"

#include <algorithm>

namespace refraster::bench {

std::vector<std::string> rungs_of(const Run& run) {
  std::vector<std::string> rungs;
  const auto add = [&](const std::string& rung) {
    if (std::find(rungs.begin(), rungs.end(), rung) == rungs.end()) rungs.push_back(rung);
  };
  for (const SceneResult& scene : run.scenes)
    for (const RungResult& result : scene.rungs) add(result.rung);
  for (const ScalingCurve& curve : run.scaling) add(curve.rung);
  return rungs;
}

std::size_t place_of(const std::vector<std::string>& rungs, const std::string& rung) {
  return static_cast<std::size_t>(std::find(rungs.begin(), rungs.end(), rung) - rungs.begin());
}

std::vector<LegendEntry> rung_legend(const Run& run) {
  std::vector<LegendEntry> legend;
  for (const std::string& rung : rungs_of(run)) legend.push_back({rung_class(legend.size()), rung});
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
