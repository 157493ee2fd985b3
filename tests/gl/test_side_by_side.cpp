// Every scene of the gallery through Mesa's drivers.

#include "io/scene_file.h"
#include "tests/gl/side_by_side.h"
#include "tests/scenes/half_textured.h"
#include "tests/scenes/listed_scenes.h"

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

std::string told(const WorstPixel& pixel) {
  std::ostringstream text;
  text << "(" << pixel.x << ", " << pixel.y << ") " << pixel.object << ", " << pixel.cause << ", " << pixel.difference
       << " levels";
  for (int c = 0; c < 3; ++c)
    text << "; " << pixel.ours[c] << " here, " << pixel.gl[c] << " there, allowed " << pixel.allowed[c];
  return text.str();
}

/// Gives the largest share of its bound that a pixel uses.
double check_scene(const std::string& name, const Scene& scene, int width, int height, const DriverProfile& profile) {
  const SideBySide found = side_by_side(scene, width, height, profile);
  INFO(name << " through " << found.driver << ", " << width << " x " << height << ": " << found.equal
            << " pixels equal, " << found.off_by_one << " off by one level, " << found.off_by_more << " by more, "
            << found.edge_pixels << " on edges");
  for (const WorstPixel& pixel : found.unexplained) MESSAGE(name << ": " << told(pixel));
  CHECK(found.coverage_pixels == 0);
  CHECK(found.over_bound == 0);
  CHECK(found.levels_not_rounded == 0);
  return found.worst_share_of_bound;
}
double check_scene(const std::string& path, int width, int height, const DriverProfile& profile) {
  return check_scene(std::filesystem::path(path).stem(), listed_scene(path), width, height, profile);
}

void check_gallery(std::string_view profile_name, int width, int height) {
  double largest_share = 0;
  for (const std::string& path : listed_scenes())
    largest_share = std::max(largest_share, check_scene(path, width, height, profile(profile_name)));
  // A bound that nothing comes near would be no test.
  CHECK(largest_share > 0.7);
}

} // namespace

TEST_CASE("a scene through llvmpipe shows the same surfaces, in colours within the bound") {
  for (const std::string& path : quick_scenes()) check_scene(path, 112, 63, profile("llvmpipe"));
}

TEST_CASE("on triangles without texture coordinates llvmpipe shows no texture either") {
  for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear})
    check_scene("half_textured", half_textured(filter), 160, 90, profile("llvmpipe"));
}

TEST_SUITE_BEGIN("slow");

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
