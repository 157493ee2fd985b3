// Every scene of the gallery through Mesa's drivers.

#include <refraster/files.h>
#include <refraster/mesh.h>

#include "tests/support/gl/side_by_side.h"
#include "tests/support/scenes/half_textured.h"
#include "tests/support/scenes/listed_scenes.h"
#include "tests/system/gl/small_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

using namespace refraster;

namespace {

const DriverProfile& profile(std::string_view name) {
  return *std::find_if(std::begin(driver_profiles), std::end(driver_profiles),
                       [&](const DriverProfile& listed) { return listed.name == name; });
}

std::string reported(const WorstPixel& pixel) {
  std::ostringstream text;
  text << "(" << pixel.x << ", " << pixel.y << ") " << pixel.object << ", " << pixel.cause << ", " << pixel.difference
       << " levels";
  for (int c = 0; c < 3; ++c)
    text << "; " << pixel.ours[c] << " here, " << pixel.gl[c] << " there, allowed " << pixel.allowed[c];
  return text.str();
}

/// Gives the largest fraction of its bound that a pixel uses.
double check_scene(const std::string& name, const Scene& scene, int width, int height, const DriverProfile& profile) {
  const SideBySide found = side_by_side(scene, width, height, profile);
  INFO(name << " through " << found.driver << ", " << width << " x " << height << ": " << found.equal
            << " pixels equal, " << found.off_by_one << " off by one level, " << found.off_by_more << " by more, "
            << found.edge_pixels << " on edges");
  for (const WorstPixel& pixel : found.unexplained) MESSAGE(name << ": " << reported(pixel));
  CHECK(found.coverage_pixels == 0);
  CHECK(found.over_bound == 0);
  CHECK(found.levels_not_rounded == 0);
  return found.worst_fraction_of_bound;
}
double check_scene(const std::string& path, int width, int height, const DriverProfile& profile) {
  return check_scene(std::filesystem::path(path).stem(), listed_scene(path), width, height, profile);
}

void check_gallery(std::string_view profile_name, int width, int height) {
  double largest_fraction = 0;
  for (const std::string& path : listed_scenes())
    largest_fraction = std::max(largest_fraction, check_scene(path, width, height, profile(profile_name)));
  // A bound that nothing comes near would be no test.
  CHECK(largest_fraction > 0.7);
}

} // namespace

TEST_CASE("a scene through llvmpipe shows the same surfaces, in colours within the bound") {
  for (const std::string& path : quick_scenes()) check_scene(path, 112, 63, profile("llvmpipe"));
}

TEST_CASE("images of one row, of one column and of odd sides show the same surfaces, in colours within the bound") {
  for (const std::string& path : quick_scenes())
    for (const auto& [width, height] : {std::pair(64, 1), std::pair(1, 63), std::pair(31, 33), std::pair(1, 1)})
      check_scene(path, width, height, profile("llvmpipe"));
}

TEST_CASE("the bound grows with the distance from the lower left corner, where OpenGL's window begins") {
  // The same triangle in all four corners of the window, mirrored there: nothing but the distance differs.
  constexpr int side = 255;
  Phong dull;
  dull.ks = Double3(0);
  Scene scene = ball(dull);
  scene.point_lights.clear();
  scene.direction_lights = {{{0, 0, -1}, Double3(1)}};
  scene.camera.position = {0, 0, 1}; // and looks at the origin, with 90 degrees
  scene.camera.fov_y_degrees = 90;
  Object& object = scene.objects[0];
  Mesh triangle;
  triangle.positions = {{-1, -1, 0}, {-0.9375f, -1, 0.0625f}, {-1, -0.9375f, 0.0625f}};
  triangle.normals = {{0, 0, 1}, {0.6f, 0, 0.8f}, {0, 0.6f, 0.8f}};
  triangle.triangles = {{0, 1, 2}};
  object.mesh = std::make_shared<const Mesh>(triangle);
  object.rotate_degrees = Double3(0);
  struct Bounds {
    double colour, depth;
  };
  const auto bounds = [&](double mirror_x, double mirror_y) {
    object.scale = {mirror_x, mirror_y, 1};
    const ColourBound bound(scene, side, side, profile("llvmpipe").tolerances);
    const int x = mirror_x > 0 ? 2 : side - 3, y = mirror_y > 0 ? side - 3 : 2;
    return Bounds{bound.at(0, 0, x, y, BoundPart::whole).either_way.x, bound.depth_error(0, 0, x, y)};
  };
  const auto check = [](const Bounds& far, const Bounds& near) {
    CHECK(far.colour > near.colour);
    CHECK(far.depth > near.depth);
  };
  const Bounds lower_left = bounds(1, 1), lower_right = bounds(-1, 1), upper_left = bounds(1, -1),
               upper_right = bounds(-1, -1);
  check(lower_right, lower_left);
  check(upper_left, lower_left);
  check(upper_right, lower_right);
  check(upper_right, upper_left);
}

TEST_CASE("on triangles without texture coordinates llvmpipe shows no texture either") {
  for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear})
    check_scene("half_textured", half_textured(filter), 160, 90, profile("llvmpipe"));
}

TEST_SUITE_BEGIN("slow");

TEST_CASE("a ground seen edge on through llvmpipe without its shortcuts has levels of detail within the bound") {
  // Toward the horizon a row's step in the texture is up to twice that of the row below: it tells which two rows make
  // a block. In a window of odd height the lowest row begins a block, and the highest has one of its own.
  Texture stripes;
  stripes.levels.push_back({1, 64, {}});
  for (int i = 0; i < 64; ++i)
    for (int c = 0; c < 3; ++c) stripes.levels[0].rgb.push_back(i % 7 < 3 ? 255.0f : 10.0f);
  build_mip_levels(stripes);
  Scene scene = ball(Phong{});
  Object& ground = scene.objects[0];
  ground.mesh = std::make_shared<const Mesh>(plane_mesh(1));
  ground.position = {0, -1, 0};
  ground.scale = {20, 1, 20};
  ground.rotate_degrees = Double3(0);
  ground.material.texture = std::make_shared<const Texture>(stripes);
  ground.material.texture_filter = TextureFilter::trilinear;
  for (const auto& [width, height] : {std::pair(32, 32), std::pair(32, 33), std::pair(33, 35)}) {
    const SideBySide found = side_by_side(scene, width, height, profile("llvmpipe-precise"));
    CAPTURE(found.height);
    CHECK(found.coverage_pixels == 0);
    CHECK(found.over_bound == 0);
  }
}

TEST_CASE("every scene through llvmpipe as it is shipped shows the same surfaces, in colours within the bound") {
  check_gallery("llvmpipe", 320, 180);
}

TEST_CASE(
    "every scene through llvmpipe without its shortcuts shows the same surfaces, in colours within a close bound") {
  check_gallery("llvmpipe-precise", 320, 180);
}

TEST_CASE("every scene through softpipe shows the same surfaces, in colours within the bound") {
  check_gallery("softpipe", 128, 72);
}

TEST_SUITE_END();
