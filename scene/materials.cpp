#include <refraster/scene.h>

#include <algorithm>

namespace refraster {

MaterialRange material_range(const Object& object, std::uint32_t triangle) {
  const auto triangles = static_cast<std::uint32_t>(object.mesh->triangles.size());
  const std::vector<TriangleRun>& runs = object.mesh->material_runs;
  if (object.materials.empty() || runs.empty()) return {&object.material, triangles};
  const auto next = std::upper_bound(runs.begin(), runs.end(), triangle,
                                     [](std::uint32_t t, const TriangleRun& run) { return t < run.first_triangle; });
  const std::uint32_t number = next == runs.begin() ? no_material : std::prev(next)->material;
  return {number < object.materials.size() ? &object.materials[number] : &object.material,
          next == runs.end() ? triangles : next->first_triangle};
}

} // namespace refraster
