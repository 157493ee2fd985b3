// Samples that lie exactly on an edge.

#include "tests/support/gl/side_by_side.h"
#include "tests/system/gl/window_scenes.h"

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
  for (const DriverProfile& profile : driver_profiles) {
    if (profile.name == "llvmpipe-precise") continue; // is a process of its own, and covers the same samples
    const SideBySide found = side_by_side(scene, size.width, size.height, profile);
    CAPTURE(std::string(profile.name));
    CHECK(found.coverage_pixels == 0);
    CHECK(found.over_bound == 0);
    // Both of Mesa's drivers draw the lower edge, y being up, where we draw the upper one: three lines of 12 pixels.
    // softpipe draws the right edge too, where we draw the left one.
    CHECK(found.edge_pixels >= 3 * 12);
    // Lines through points up to 16, in double: three products and two sums.
    CHECK(found.farthest_edge <= 16 * 5 * 0x1p-53);
  }
}
