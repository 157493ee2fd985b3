// Samples that lie exactly on an edge.

#include "tests/support/gl/device_images.h"
#include "tests/system/gl/window_scenes.h"
#include "verify/device/read_profile.h"

#include <doctest/doctest.h>

using namespace refraster;

namespace {

constexpr WindowSize size = {16, 16};

/// Eight triangles around a hub, which is the centre of a pixel, as are many points of its spokes (two horizontal, two
/// vertical, four diagonal) and of the rim, a square of 12 x 12 pixels. Each has its depth, nearer than the one before.
std::vector<Float3> fan(float first_z, float z_step) {
  constexpr float hub_x = 0.0625f, hub_y = -0.0625f, reach = 0.75f; // exact: multiples of half a pixel
  constexpr float rim[9][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
  std::vector<Float3> corners;
  for (std::size_t i = 0; i < 8; ++i) {
    const float z = first_z + z_step * static_cast<float>(i);
    corners.push_back({hub_x, hub_y, z});
    for (const std::size_t k : {i, i + 1}) corners.push_back({hub_x + reach * rim[k][0], hub_y + reach * rim[k][1], z});
  }
  return corners;
}

} // namespace

TEST_CASE("OpenGL draws a sample on a shared edge once") {
  Scene scene = scene_before_the_eye();
  scene.objects = {shining(fan(0.5f, -0.0625f))};
  for (const GlRenderer renderer : software_renderers) {
    const GlFrame frame = drawn_with(scene, clip_space_vertex_shader, writing("vec3(1.0)"), size, renderer);
    // A second time would pass the depth test again. Of two opposite sides of the rim one is drawn.
    CHECK(frame.samples_passed == 12 * 12);
    int drawn = 0;
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) drawn += frame.ids.at(x, y)[1] != 0;
    CHECK(drawn == 12 * 12);
  }
}

TEST_CASE("where OpenGL's rule for ties shows another triangle than ours, it is judged as an edge") {
  Scene scene = scene_before_the_eye();
  scene.objects = {shining(fan(-1, 0))};
  for (const char* const name : {"llvmpipe", "softpipe"}) {
    const DeviceProfile profile = device_profile(name);
    GlOptions options;
    options.width = size.width, options.height = size.height;
    options.renderer = profile.renderer;
    options.want_radiance = options.want_ids = true;
    const GlFrame frame = render_gl(scene, options);
    const Verdict verdict = judge(scene, in_float(frame), profile, {});
    CAPTURE(name);
    CHECK(verdict.is_explained());
    // Both of Mesa's drivers draw the lower edge, y being up, where we draw the upper one: three lines of 12 pixels.
    // softpipe draws the right edge too, where we draw the left one.
    int others = 0;
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) others += frame.ids.at(x, y)[1] != *verdict.triangle.at(x, y);
    CHECK(others >= 3 * 12);
    // Both of two that have one colour look the same: only at the rim does the image show it.
    CHECK(verdict.count(PixelClass::exact) + verdict.count(PixelClass::rounding) + verdict.count(PixelClass::edge) ==
          verdict.classes.values.size());
    CHECK(verdict.count(PixelClass::edge) >= 3 * 12);
  }
}
