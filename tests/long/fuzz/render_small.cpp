#include "tests/long/fuzz/render_small.h"

#include "math/precisions.h"
#include "tests/long/fuzz/targets.h"
#include "tests/support/invariants.h"

#include <algorithm>

namespace refraster::fuzz {

void render_small(const Scene& scene, std::size_t variant) {
  constexpr Precision precisions[] = {Precision::double_, Precision::float_, Precision::fast};
  RenderOptions options;
  options.width = options.height = 8;
  options.threads = 1;
  options.precision = precisions[variant % 3];
  options.samples = 1 << (variant % 5);
  options.want_radiance = true;
  options.aovs = test::all_aovs();
  // Keeps its memory, as an embedding program would.
  static Renderer renderer;
  static Frame frame;
  renderer.render(scene, options, frame);
  require_none(test::fault_of(frame, scene, options), "the frame");
}

Scene showing(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const Texture> texture, TextureFilter filter) {
  Double3 low(0), high(0);
  for (const Float3& p : mesh->positions) {
    const Double3 at(p);
    low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
  }
  const Double3 centre = 0.5 * low + 0.5 * high;
  const double size = std::max({1e-30, high.x - low.x, high.y - low.y, high.z - low.z});
  Scene scene;
  scene.camera.target = centre;
  scene.camera.position = centre + Double3(0.1, 0.2, 1) * (2 * size);
  scene.camera.near = 1e-3 * size;
  scene.camera.far = 10 * size;
  scene.point_lights.push_back({scene.camera.position, {1, 1, 1}, 1, 0, 0});
  scene.direction_lights.push_back({{0.3, -0.5, -1}, {0.5, 0.6, 0.7}});
  Object& object = scene.objects.emplace_back();
  object.mesh = std::move(mesh);
  object.material.diffuse_map.texture = std::move(texture);
  object.material.diffuse_map.filter = filter;
  return scene;
}

} // namespace refraster::fuzz
