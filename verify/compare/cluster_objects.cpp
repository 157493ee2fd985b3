#include "verify/compare/cluster_objects.h"

#include <refraster/render.h>

#include "verify/compare/clusters.h"

#include <algorithm>

namespace refraster {

std::vector<std::string> object_labels(const Scene& scene) {
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const std::string& name = scene.objects[i].name;
    const auto same = std::count_if(scene.objects.begin(), scene.objects.end(),
                                    [&](const Object& other) { return other.name == name; });
    const std::string number = "object " + std::to_string(i + 1);
    if (name.empty()) labels.push_back(number);
    else labels.push_back(same == 1 ? name : name + " (" + number + ")");
  }
  return labels;
}

Image<std::uint32_t> ids_of(const Image<float>& aov) {
  Image<std::uint32_t> ids(aov.width, aov.height, 1);
  for (std::size_t i = 0; i < ids.values.size(); ++i) {
    const float id = aov.values[i * static_cast<std::size_t>(aov.channels)];
    ids.values[i] = id >= 0 && id < 0x1p32F ? static_cast<std::uint32_t>(id) : 0;
  }
  return ids;
}

SeenObjects seen_objects(const Scene& scene, int width, int height, const MemoryBudget& memory) {
  RenderOptions options;
  options.width = width;
  options.height = height;
  options.want_rgb8 = false;
  options.aovs = {Aov::object, Aov::triangle};
  options.memory = memory;
  const Frame frame = render(scene, options);
  return {object_labels(scene), ids_of(frame.aovs[0]), ids_of(frame.aovs[1])};
}

ObjectCounts cluster_objects(const Image<std::uint8_t>& marked, const Cluster& cluster, const SeenObjects& seen) {
  std::vector<std::uint64_t> counts(seen.names.size() + 1);
  for (const auto& [x, y] : cluster_pixels(marked, cluster)) ++counts.at(*seen.object.at(x, y));
  ObjectCounts result;
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] > 0) result.emplace_back(i == 0 ? "background" : seen.names[i - 1], counts[i]);
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  return result;
}

} // namespace refraster
