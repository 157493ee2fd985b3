// The faults that a verdict must find, and whether hypotheses name what they are.

#include "gl/render_gl.h"
#include "tests/support/files/malformed_inputs.h"
#include "tests/support/gl/judged_pixels.h"
#include "tests/support/gl/seeded_faults.h"
#include "tests/support/scenes/fault_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
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

/// How often the right cause was named.
struct Named {
  int covered = 0, first = 0, among_three = 0;
  int not_covered = 0, wrongly = 0; // of those that no hypothesis covers: more than half of the pixels explained
};

void judge(const SeededFault& fault, const Image<float>& actual, StoredAs as, const PixelJudge& judge, Named& named) {
  const hypotheses::RankRequest request = judge.request(actual, as, 1);
  if (request.unexplained.size() < 10) return; // in 8 bits some do not show
  const hypotheses::Ranking ranking = rank_hypotheses(request);
  const auto is_right = [&](const hypotheses::Cause& cause) {
    return std::all_of(cause.keys.begin(), cause.keys.end(), [&](const std::string& key) {
      return std::find(fault.causes.begin(), fault.causes.end(), key) != fault.causes.end();
    });
  };
  const auto found = std::find_if(ranking.causes.begin(), ranking.causes.end(), is_right) - ranking.causes.begin();
  std::string text = std::string(fault.name) + (as == StoredAs::rgb8 ? ", 8 bits:" : ", floats:");
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

} // namespace

TEST_SUITE("slow") {
  TEST_CASE(
      "every seeded fault shows on a scene, and where a hypothesis covers it, it is named; where none does, none is") {
    std::vector<std::unique_ptr<PixelJudge>> judges;
    std::vector<Image<float>> right;
    for (const FaultScene& place : fault_scenes()) {
      judges.push_back(std::make_unique<PixelJudge>(place.scene, size.width, size.height));
      right.push_back(drawn(place.scene));
      for (const StoredAs as : {StoredAs::floats, StoredAs::rgb8}) {
        const Image<float> image = stored(right.back(), as);
        CHECK_MESSAGE(judges.back()->request(image, as, 1).unexplained.empty(), place.name);
      }
    }
    Named floats, levels;
    for (const SeededFault& fault : seeded_faults()) {
      bool shows = false;
      // On the first scene where it does.
      for (std::size_t i = 0; i < fault_scenes().size() && !shows; ++i) {
        const TemporaryFolder folder;
        const std::optional<Scene> scene = with_fault(fault_scenes()[i].scene, fault, size, folder.path);
        if (!scene) continue;
        const Image<float> image = fault.image ? fault.image(right[i]) : drawn(*scene);
        shows = different(right[i], image) >= 10;
        if (!shows) continue;
        judge(fault, image, StoredAs::floats, *judges[i], floats);
        judge(fault, stored(image, StoredAs::rgb8), StoredAs::rgb8, *judges[i], levels);
      }
      CHECK_MESSAGE(shows, fault.name);
    }
    for (const Named& named : {floats, levels}) {
      CHECK(named.covered >= 60);
      CHECK(named.not_covered >= 8);
      CHECK(named.first >= 0.85 * named.covered);
      CHECK(named.among_three >= 0.97 * named.covered);
      CHECK(named.wrongly == 0);
      MESSAGE("of " << named.covered << " faults " << named.first << " are first, " << named.among_three
                    << " among the first three");
    }
  }
}
