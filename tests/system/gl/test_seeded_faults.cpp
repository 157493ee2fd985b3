// The faults that a verdict must find: each is one, and none but it.

#include "gl/render_gl.h"
#include "tests/support/files/malformed_inputs.h"
#include "tests/support/gl/fault_scenes.h"
#include "tests/support/gl/seeded_faults.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace refraster;
using refraster::test::TemporaryFolder;

namespace {

constexpr FaultImageSize size{128, 96};

Image<float> drawn(const Scene& scene) {
  GlOptions options;
  options.width = size.width, options.height = size.height;
  options.renderer = GlRenderer::llvmpipe;
  options.want_rgb8 = false, options.want_radiance = true;
  return render_gl(scene, options).radiance;
}

/// Pixels that differ by more than a level.
int different(const Image<float>& a, const Image<float>& b) {
  int count = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      bool differs = false;
      for (int c = 0; c < 3; ++c) differs |= !(std::abs(a.at(x, y)[c] - b.at(x, y)[c]) <= 1.0f / 255);
      count += differs;
    }
  return count;
}

} // namespace

TEST_CASE("seeded faults have names of their own, and at least forty are in GLSL, ten in scenes and ten in images") {
  std::set<std::string_view> names;
  int glsl = 0, scenes = 0, images = 0;
  for (const SeededFault& fault : seeded_faults()) {
    CHECK_MESSAGE(names.insert(fault.name).second, fault.name);
    CHECK(!fault.glsl.empty() + (fault.scene != nullptr) + (fault.image != nullptr) == 1);
    glsl += !fault.glsl.empty(), scenes += fault.scene != nullptr, images += fault.image != nullptr;
  }
  CHECK(glsl >= 40);
  CHECK(scenes >= 10);
  CHECK(images >= 10);
}

TEST_SUITE("slow") {
  TEST_CASE("every seeded fault shows on a scene: OpenGL draws another image with it") {
    std::vector<int> most(seeded_faults().size(), 0);
    for (const FaultScene& place : fault_scenes()) {
      const Image<float> right = drawn(place.scene);
      for (std::size_t i = 0; i < seeded_faults().size(); ++i) {
        const SeededFault& fault = seeded_faults()[i];
        const TemporaryFolder folder;
        const std::optional<Scene> scene = with_fault(place.scene, fault, size, folder.path);
        if (!scene) continue;
        const int count = different(right, fault.image ? fault.image(right) : drawn(*scene));
        INFO(std::string(fault.name) << " on " << std::string(place.name) << ": " << count);
        most[i] = std::max(most[i], count);
      }
    }
    for (std::size_t i = 0; i < most.size(); ++i)
      CHECK_MESSAGE(most[i] >= 10, seeded_faults()[i].name << " shows in " << most[i] << " pixels");
  }
}
