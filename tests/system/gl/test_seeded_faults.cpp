// The faults that a verdict must find, and whether hypotheses name what they are.

#include "gl/render_gl.h"
#include "tests/support/files/malformed_inputs.h"
#include "tests/support/gl/device_images.h"
#include "tests/support/gl/seeded_faults.h"
#include "tests/support/scenes/fault_scenes.h"
#include "verify/device/read_profile.h"
#include "verify/verdict/rank_request.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
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

namespace {

enum class StoredAs { floats, rgb8 };

/// As a file of that kind holds it.
DeviceImage stored(const Image<float>& radiance, StoredAs as) {
  DeviceImage image;
  image.colour = radiance;
  image.full_scale = 1, image.precision = StoredPrecision::floats(float_rounding);
  if (as == StoredAs::floats) return image;
  for (float& value : image.colour.values)
    value = static_cast<float>(std::nearbyint(255 * std::clamp(static_cast<double>(value), 0.0, 1.0)));
  image.full_scale = 255, image.precision = StoredPrecision::integers(255);
  return image;
}

/// How often a fault was found, and the right cause named.
struct Named {
  int faults = 0, found = 0;
  int covered = 0, first = 0, among_three = 0;
  int not_covered = 0, wrongly = 0; // of those that no hypothesis covers: more than half of the pixels explained
};

void judge_fault(const SeededFault& fault, const Scene& scene, const DeviceImage& image, const DeviceProfile& profile,
                 Named& named) {
  const bool in_8_bits = image.full_scale == 255;
  const JudgeOptions options;
  const Verdict verdict = judge(scene, image, profile, options);
  ++named.faults;
  std::string text = std::string(fault.name) + (in_8_bits ? ", 8 bits:" : ", floats:");
  if (verdict.is_explained()) {
    MESSAGE("not found: " << text);
    return;
  }
  ++named.found;
  if (verdict.count(PixelClass::unexplained) < 10) return; // too few to tell causes apart
  Image<float> values;
  const hypotheses::RankRequest request = hypotheses::rank_request(scene, image, profile, options, verdict, values);
  const hypotheses::Ranking ranking = rank_hypotheses(request);
  const auto is_right = [&](const hypotheses::Cause& cause) {
    return std::all_of(cause.keys.begin(), cause.keys.end(), [&](const std::string& key) {
      return std::find(fault.causes.begin(), fault.causes.end(), key) != fault.causes.end();
    });
  };
  const auto found = std::find_if(ranking.causes.begin(), ranking.causes.end(), is_right) - ranking.causes.begin();
  for (std::size_t i = 0; i < std::min<std::size_t>(ranking.causes.size(), 3); ++i)
    text += "\n  " + sentence(ranking.causes[i], ranking, request.scene);
  if (fault.causes.empty()) {
    ++named.not_covered;
    const bool wrong = ranking.named() != nullptr;
    named.wrongly += wrong;
    CHECK_MESSAGE(!wrong, text);
    return;
  }
  ++named.covered;
  const bool here = found < static_cast<std::ptrdiff_t>(ranking.causes.size());
  named.first += here && found == 0, named.among_three += here && found < 3;
  if (!here || found > 0) MESSAGE("not first: " << text);
}

/// Draws and judges every `step`-th fault, each on the first scene where it shows, in floats and in 8 bits.
std::array<Named, 2> judge_faults(std::size_t step) {
  const DeviceProfile profile = device_profile("llvmpipe");
  std::vector<Image<float>> right;
  for (const FaultScene& place : fault_scenes()) {
    right.push_back(drawn(place.scene));
    for (const StoredAs as : {StoredAs::floats, StoredAs::rgb8})
      CHECK_MESSAGE(judge(place.scene, stored(right.back(), as), profile, {}).is_explained(), place.name);
  }
  Named floats, levels;
  for (std::size_t k = 0; k < seeded_faults().size(); k += step) {
    const SeededFault& fault = seeded_faults()[k];
    bool shows = false;
    for (std::size_t i = 0; i < fault_scenes().size() && !shows; ++i) {
      const TemporaryFolder folder;
      const std::optional<Scene> scene = with_fault(fault_scenes()[i].scene, fault, size, folder.path);
      if (!scene) continue;
      const Image<float> image = fault.image ? fault.image(right[i]) : drawn(*scene);
      shows = different(right[i], image) >= 10;
      if (!shows) continue;
      judge_fault(fault, fault_scenes()[i].scene, stored(image, StoredAs::floats), profile, floats);
      judge_fault(fault, fault_scenes()[i].scene, stored(image, StoredAs::rgb8), profile, levels);
    }
    CHECK_MESSAGE(shows, fault.name);
  }
  for (const Named& named : {floats, levels})
    MESSAGE("of " << named.faults << " faults " << named.found << " are found; of " << named.covered
                  << " that a hypothesis covers it is first for " << named.first << ", among the first three for "
                  << named.among_three);
  CHECK(floats.found == floats.faults);
  CHECK(levels.found >= 0.9 * levels.faults);
  for (const Named& named : {floats, levels}) {
    CHECK(named.first >= 0.85 * named.covered);
    CHECK(named.among_three >= 0.97 * named.covered);
    CHECK(named.wrongly == 0);
  }
  return {floats, levels};
}

} // namespace

TEST_SUITE("slow") {
  TEST_CASE("every eighth seeded fault is found, and where a hypothesis covers it, named; where none does, none is") {
    judge_faults(8);
  }
}

TEST_SUITE("long") {
  TEST_CASE("every seeded fault is found, and where a hypothesis covers it, named; where none does, none is") {
    for (const Named& named : judge_faults(1)) {
      CHECK(named.covered >= 60);
      CHECK(named.not_covered >= 8);
    }
  }
}
