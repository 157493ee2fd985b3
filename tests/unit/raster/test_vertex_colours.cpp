// Colours of a mesh's vertices: what they do to a picture of light that is the same everywhere.

#include <refraster/mesh.h>
#include <refraster/render.h>
#include <refraster/scene.h>

#include "tests/support/scenes/poster.h"

#include <doctest/doctest.h>

#include <cmath>

namespace refraster::test {
namespace {

/// A square that fills the image under ambient light of 1: its vertices' colours are what is seen.
Scene poster(std::vector<Float3> colours) {
  Phong ambient;
  ambient.ka = Double3(1), ambient.kd = ambient.ks = Double3(0);
  Scene scene = poster_scene(ambient);
  change_mesh(scene, [&](Mesh& mesh) { mesh.uvs.clear(), mesh.colours = std::move(colours); });
  return scene;
}

/// The square's corners lie on the image's, and places are small multiples of 1/32: what is left is the rounding of
/// three weights, their sum, its reciprocal, and of products and sums with them, each half an ulp of at most 1.
constexpr double roundings = 8 * 0x1p-53;
bool is_near(double found, double expected) {
  return std::abs(found - expected) <= roundings;
}

Image<double> radiance(const Scene& scene, int samples = 1) {
  RenderOptions options;
  options.width = options.height = 16;
  options.samples = samples;
  options.want_radiance_double = true;
  return render(scene, options).radiance_double;
}

} // namespace

TEST_CASE("a vertex's colour is seen at its place, and what is between them between") {
  // Red grows with x, blue with y: linear functions, which interpolation by any weights gives back.
  const Scene scene = poster({{0, 0.5f, 0}, {1, 0.5f, 0}, {1, 0.5f, 1}, {0, 0.5f, 1}});
  const Image<double> image = radiance(scene);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const double* const rgb = image.at(x, y);
      CHECK(is_near(rgb[0], (x + 0.5) / 16));
      CHECK(is_near(rgb[2], (15.5 - y) / 16));
      CHECK(rgb[1] == 0.5); // the same at all corners: no rounding
    }
}

TEST_CASE("vertices without a colour are white where others have one, and a mesh of white ones is one without") {
  CHECK(radiance(poster({{1, 1, 1}})).values == radiance(poster({})).values);
  const Image<double> image = radiance(poster({{0, 0, 0}})); // the lower left one only, which both triangles have
  CHECK(is_near(image.at(15, 0)[0], 1 - 1.0 / 32));          // the pixel's centre is a 32nd of the diagonal off
  CHECK(is_near(image.at(0, 15)[0], 1.0 / 32));
}

TEST_CASE("where a pixel's centre lies beside the triangle the colour goes on, but not below 0") {
  Scene scene = poster({{0, 1, 1}, {1, 1, 1}, {1, 1, 1}, {0, 1, 1}});
  scene.objects[0].scale.x = 0.995; // of the first column only some samples are covered, and no centre
  scene.objects[0].position.x = 0.07;
  const Image<double> image = radiance(scene, 16);
  for (const double value : image.values) CHECK(value >= 0);
}

} // namespace refraster::test
