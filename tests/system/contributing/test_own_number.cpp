// The worked example of docs/number.md does what that page says.

#include <refraster/mesh.h>
#include <refraster/render.h>

#include "counted.h"

#include <doctest/doctest.h>

namespace refraster {
namespace {

Scene ball() {
  Scene scene;
  scene.camera.position = {0, 0, 4};
  scene.direction_lights = {{{-1, -1, -1}, Double3(1)}};
  Object object;
  object.mesh = std::make_shared<const Mesh>(sphere_mesh(16, 8));
  BlinnPhong function;
  function.glossiness = 20;
  object.material.fragment_function = function;
  scene.objects.push_back(object);
  return scene;
}

} // namespace

TEST_CASE("a number of one's own renders a frame, close to that of double, and counts its operations") {
  const Scene scene = ball();
  RenderOptions options;
  options.width = 24, options.height = 16, options.threads = 2;
  options.want_radiance_double = true;
  const Frame reference = render(scene, options);
  Counted::operations = 0;
  const Image<Counted> counted = render_in<Counted>(scene, options);
  // The highlight is computed from a cosine that is off by some 2^-53, to the 20th power.
  constexpr double error = 20 * 0x1p-50;
  std::size_t lit = 0;
  for (std::size_t i = 0; i < counted.values.size(); ++i) {
    CHECK(abs(counted.values[i].value - reference.radiance_double.values[i]) <= error);
    lit += counted.values[i].value > 0;
  }
  CHECK(lit >= 100);
  CHECK(Counted::operations >= 50 * lit / 3); // some fifty a pixel at least: three quotients, two unit vectors, a power
}

} // namespace refraster
