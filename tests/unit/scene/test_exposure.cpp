// Exposure: pictures as many times as bright.

#include <refraster/mesh.h>
#include <refraster/render.h>

#include "scene/exposure.h"

#include <doctest/doctest.h>

#include <cmath>

namespace refraster::test {
namespace {

/// A ball with a highlight and light of its own, and one that is measured by nothing but its parameters.
Scene balls() {
  Scene scene;
  scene.camera.position = {0, 0, 5};
  scene.camera.target = {0, 0, 0};
  scene.background = {0.1, 0.2, 0.3};
  scene.point_lights = {{{2, 3, 4}, {5, 6, 7}, 1, 0.1, 0.2}};
  scene.direction_lights = {{{-1, -2, -3}, {0.5, 0.25, 0.125}}};
  for (const double x : {-1.1, 1.1}) {
    Object object;
    object.mesh = std::make_shared<const Mesh>(sphere_mesh(16, 8));
    object.position.x = x;
    if (x < 0) object.material.fragment_function = BlinnPhong{};
    object.material.emissive = {0.03, 0, 0.01};
    scene.objects.push_back(std::move(object));
  }
  return scene;
}

Frame drawn(const Scene& scene, Precision precision) {
  RenderOptions options;
  options.width = options.height = 24;
  options.precision = precision;
  options.want_radiance = true;
  options.aovs = {Aov::albedo, Aov::normal};
  return render(scene, options);
}

} // namespace

TEST_CASE("whole stops multiply each value of a picture exactly, and no AOV changes") {
  for (const Precision precision : {Precision::double_, Precision::float_})
    for (const double stops : {-3.0, 0.0, 1.0, 6.0}) {
      CAPTURE(stops);
      Scene brighter = balls();
      expose(brighter, stops);
      const Frame before = drawn(balls(), precision), after = drawn(brighter, precision);
      const auto factor = static_cast<float>(std::exp2(stops));
      bool equal = true; // a factor that is a power of two goes through every product and sum
      for (std::size_t i = 0; i < before.radiance.values.size(); ++i)
        equal = equal && after.radiance.values[i] == factor * before.radiance.values[i];
      CHECK(equal);
      for (std::size_t i = 0; i < before.aovs.size(); ++i) CHECK(after.aovs[i].values == before.aovs[i].values);
    }
}

} // namespace refraster::test
