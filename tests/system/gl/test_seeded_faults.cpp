// The faults that a verdict must find, and whether hypotheses name what they are.

#include "tests/support/gl/fault_images.h"
#include "verify/device/read_profile.h"
#include "verify/verdict/rank_request.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <set>

using namespace refraster;

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
  const std::vector<Image<float>> right = right_fault_images();
  for (std::size_t i = 0; i < right.size(); ++i)
    for (const StoredAs as : {StoredAs::floats, StoredAs::rgb8}) {
      const FaultScene& place = fault_scenes()[i];
      CHECK_MESSAGE(judge(place.scene, stored_image(right[i], as), profile, {}).is_explained(), place.name);
    }
  Named floats, levels;
  for (std::size_t k = 0; k < seeded_faults().size(); k += step) {
    const SeededFault& fault = seeded_faults()[k];
    const std::optional<ShownFault> shown = shown_fault(fault, right);
    CHECK_MESSAGE(shown, fault.name);
    if (!shown) continue;
    const Scene& scene = fault_scenes()[shown->scene].scene;
    judge_fault(fault, scene, stored_image(shown->image, StoredAs::floats), profile, floats);
    judge_fault(fault, scene, stored_image(shown->image, StoredAs::rgb8), profile, levels);
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
  TEST_CASE("every twelfth seeded fault is found, and where a hypothesis covers it, named; where none does, none is") {
    judge_faults(12);
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
