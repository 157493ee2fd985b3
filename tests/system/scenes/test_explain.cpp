// The story of a pixel: its numbers are those of the frame.

#include "math/vec.h"
#include "shading/precision_bounds.h"
#include "tests/support/random.h"
#include "tests/support/scenes/half_textured.h"
#include "tests/support/scenes/listed_scenes.h"
#include "tests/support/scenes/random_scene.h"
#include "tests/support/scenes/shadow_scene.h"
#include "verify/explain/explain_pixel.h"
#include "verify/explain/story_json.h"
#include "verify/explain/story_text.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace refraster {
namespace {

/// Whether a scene's numbers are such as people write: then double is as near to 60 digits as docs/precision.md says.
enum class Numbers { ordinary, any };

bool same_bits(const Double3& a, const Double3& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

/// A sum of n products of numbers whose magnitudes add up to `size`, however it is ordered: n + 1 roundings.
double rounding(double size, int n) {
  return (n + 1) * 0x1p-53 * size;
}

/// The pixel by itself, as render() has it.
struct Reference {
  Double3 radiance;
  FrameCounts counts;
  std::vector<Image<float>> aovs;
};
Reference reference(const Scene& scene, const ExplainRequest& request, Precision precision) {
  RenderOptions options;
  options.width = request.width, options.height = request.height, options.samples = request.samples;
  options.crop = PixelRect{request.x, request.y, 1, 1};
  options.precision = precision;
  options.want_rgb8 = false, options.want_radiance_double = true;
  options.aovs = {Aov::object, Aov::triangle, Aov::depth, Aov::uv};
  const Frame frame = render(scene, options);
  const std::vector<double>& rgb = frame.radiance_double.values;
  return {{rgb[0], rgb[1], rgb[2]}, frame.counts, frame.aovs};
}

void check_terms(const FragmentStory& f, Numbers numbers) {
  const Double3 emission = f.emission.value_or(Double3(0));
  Double3 sum = f.ambient, exact = f.exact.ambient + emission;
  if (f.emission) sum += emission;
  UndefinedCounts of_lights;
  REQUIRE(f.exact.reflected.size() == f.lights.size());
  for (std::size_t i = 0; i < f.lights.size(); ++i) {
    const LightStory& light = f.lights[i];
    sum += light.reflected;
    exact += f.exact.reflected[i];
    of_lights += light.undefined;
    if (light.diffuse) CHECK(same_bits((*light.diffuse + *light.specular) * light.arriving, light.reflected));
    if (light.merl) {
      const Double3 product = light.merl->lit ? light.merl->f * light.n_l * light.arriving : Double3(0);
      CHECK(same_bits(product, light.reflected));
    }
    // A term is off by no more than a pixel may be.
    for (int c = 0; c < 3 && numbers == Numbers::ordinary; ++c) {
      const double term = f.exact.reflected[i][c];
      CHECK(std::abs(light.reflected[c] - term) <= frame_error_units * 0x1p-53 * std::max(1.0, std::abs(term)));
    }
  }
  if (!f.user_function && f.undefined[Undefined::not_finite] == 0) CHECK(same_bits(sum, f.radiance));
  for (int c = 0; c < 3 && numbers == Numbers::ordinary; ++c) {
    double size = f.exact.ambient[c] + emission[c];
    for (const Double3& term : f.exact.reflected) size += term[c];
    CHECK(std::abs(exact[c] - f.exact.radiance[c]) <= rounding(size, static_cast<int>(f.lights.size())));
  }
  for (std::size_t i = 0; i < of_lights.counts.size(); ++i) CHECK(of_lights.counts[i] <= f.undefined.counts[i]);
}

void check_texture(const FragmentStory& f) {
  if (!f.texture) return;
  Double3 sum(0);
  double weights = 0;
  for (const Texel& texel : f.texture->texels) sum += texel.value * texel.weight, weights += texel.weight;
  CHECK(weights == doctest::Approx(1).epsilon(1e-12));
  sum *= f.vertex_colour.value_or(Double3(1));
  for (int c = 0; c < 3; ++c) CHECK(sum[c] == doctest::Approx(f.texture_colour[c]).epsilon(1e-12));
}

void check_tables(const FragmentStory& f) {
  for (const LightStory& light : f.lights) {
    if (!light.merl || light.merl->unmeasured) continue;
    double weights = 0;
    for (const MerlTap& tap : light.merl->taps) {
      weights += tap.weight;
      if (tap.unmeasured) CHECK(tap.weight == 0);
    }
    CHECK(weights == doctest::Approx(1).epsilon(1e-12));
  }
}

/// What holds of every pixel.
void check_story(const Scene& scene, const ExplainRequest& request, Numbers numbers = Numbers::ordinary) {
  CAPTURE(request.x);
  CAPTURE(request.y);
  CAPTURE(request.samples);
  const PixelStory story = explain_pixel(scene, request);
  for (const Precision precision : {Precision::double_, Precision::exact}) {
    const Reference frame = reference(scene, request, precision);
    CHECK(same_bits(story.in(precision).radiance, frame.radiance));
  }
  const Reference frame = reference(scene, request, Precision::double_);
  REQUIRE(story.fragments.size() == frame.counts.fragments);
  UndefinedCounts undefined;
  for (const FragmentStory& f : story.fragments) {
    check_terms(f, numbers);
    check_texture(f);
    check_tables(f);
    undefined += f.undefined;
  }
  CHECK(undefined.counts == frame.counts.undefined.counts);
  for (const SampleStory& sample : story.sample_stories)
    CHECK(std::is_sorted(sample.candidates.begin(), sample.candidates.end(),
                         [](const CoveringTriangle& a, const CoveringTriangle& b) { return a.depth < b.depth; }));
  if (request.samples > 1) return;
  const std::vector<CoveringTriangle>& candidates = story.sample_stories.front().candidates;
  const auto seen = std::find_if(candidates.begin(), candidates.end(),
                                 [](const CoveringTriangle& c) { return c.fate == CandidateFate::seen; });
  if (story.fragments.empty()) {
    CHECK(seen == candidates.end());
    for (const CoveringTriangle& c : candidates) CHECK(c.fate != CandidateFate::hidden);
    CHECK(frame.counts.shaded == 0);
    return;
  }
  REQUIRE(seen != candidates.end());
  const FragmentStory& f = story.fragments.front();
  CHECK(same_bits(f.radiance, frame.radiance));
  CHECK(same_bits(f.exact.radiance, story.in(Precision::exact).radiance));
  CHECK(static_cast<float>(seen->of.object) == frame.aovs[0].values[0]);
  CHECK(static_cast<float>(seen->of.triangle) == frame.aovs[1].values[0]);
  CHECK(static_cast<float>(seen->depth) == frame.aovs[2].values[0]); // the very bits that the depth test had
  CHECK(seen->weights == f.weights);
  for (auto c = candidates.begin(); c != seen; ++c)
    CHECK((c->fate != CandidateFate::hidden || c->depth == seen->depth)); // what is nearer is not drawn
}

void check_some_pixels(const Scene& scene, int pixels) {
  Random random(15);
  for (int i = 0; i < pixels; ++i) {
    const ExplainRequest request{random.below(320), random.below(180), 320, 180};
    check_story(scene, request);
  }
}

} // namespace

TEST_CASE("the explained terms of the gallery's pixels add up to the frame's pixels, bit for bit") {
  for (const std::string& path : quick_scenes()) {
    CAPTURE(path);
    check_some_pixels(listed_scene(path), 12);
  }
}

TEST_CASE("the story of a random pixel of a random scene is that of the frame, with any number of samples") {
  Random random(7);
  for (int i = 0; i < 40; ++i) {
    CAPTURE(i);
    const Scene scene = test::random_scene(random);
    const RenderOptions options = test::random_options(random);
    const ExplainRequest request{random.below(options.width), random.below(options.height), options.width,
                                 options.height, options.samples};
    check_story(scene, request, Numbers::any);
    const PixelStory story = explain_pixel(scene, request);
    CHECK_FALSE(story_text(story).empty());
    CHECK_FALSE(story_json(story).empty());
  }
}

TEST_CASE("the story of a pixel in the shadow of something says of what, and what it would be without") {
  const Scene scene = shadow_scene();
  int in_shadow = 0, in_light = 0;
  for (int i = 0; i < 60; ++i) {
    const ExplainRequest request{5 + i * 5 % 310, 90 + i, 320, 180, i % 4 == 0 ? 4 : 1};
    CAPTURE(i);
    check_story(scene, request);
    const PixelStory story = explain_pixel(scene, request);
    for (const FragmentStory& f : story.fragments)
      for (const LightStory& light : f.lights) {
        const bool has_shadow = light.index < (light.type == "point light" ? 2 : 1);
        REQUIRE(light.shadow.has_value() == has_shadow);
        if (!has_shadow) continue;
        if (light.shadow->visibility == 1) {
          ++in_light;
          CHECK_FALSE(light.shadow->between);
          continue;
        }
        ++in_shadow;
        CHECK(light.reflected == Double3(0));
        REQUIRE(light.shadow->between);
        REQUIRE(light.shadow->reflected);
        const std::string between = "in the shadow of";
        CHECK(story_text(story, {.lights = 9}).find(between) != std::string::npos);
        CHECK(story_json(story).find("\"between\": {") != std::string::npos);
        if (story.fragments.size() > 1 || *light.shadow->reflected == Double3(0)) continue;
        ActualPixel actual;
        actual.stored = f.radiance + *light.shadow->reflected;
        actual.full_scale = 1;
        actual.precision = StoredPrecision::floats(0x1p-24);
        const PixelStory other = explain_pixel(scene, request, actual);
        REQUIRE(other.actual);
        CHECK(std::any_of(other.actual->would_be.begin(), other.actual->would_be.end(),
                          [](const WouldBe& found) { return found.remark == "as if it had no shadow"; }));
      }
  }
  CHECK(in_shadow > 20);
  CHECK(in_light > 20);
}

TEST_CASE("the story of a pixel says what a shadow map was asked, and its taps add up to the visibility") {
  ShadowMap map;
  map.size = 128;
  int parts = 0, dark = 0;
  for (const ShadowFilter filter : {ShadowFilter::nearest, ShadowFilter::two_by_two, ShadowFilter::pcf3}) {
    map.filter = filter;
    const Scene scene = with_shadows(shadow_scene(), map);
    for (int i = 0; i < 60; ++i) {
      const ExplainRequest request{5 + i * 5 % 310, 90 + i, 320, 180, 1};
      CAPTURE(i);
      check_story(scene, request);
      const PixelStory story = explain_pixel(scene, request);
      for (const FragmentStory& f : story.fragments)
        for (const LightStory& light : f.lights) {
          REQUIRE(light.shadow);
          REQUIRE(light.shadow->map);
          CHECK_FALSE(light.shadow->between);
          CHECK((light.shadow->map->face != "") == (light.type == "point light"));
          double lit = 0;
          for (const ShadowTapStory& tap : light.shadow->map->taps) {
            if (tap.lit) lit += tap.weight;
            CHECK(tap.lit == (!tap.stored || light.shadow->map->depth <= *tap.stored));
          }
          CHECK(light.shadow->visibility == doctest::Approx(lit));
          parts += light.shadow->visibility > 0 && light.shadow->visibility < 1;
          dark += light.shadow->visibility == 0;
        }
      const std::string text = story_text(story, {.lights = 9});
      if (!story.fragments.empty()) {
        CHECK(text.find("depth with bias, compared with") != std::string::npos);
        CHECK(text.find(", weight ") != std::string::npos);
        CHECK(story_json(story).find("\"taps\": [") != std::string::npos);
      }
    }
  }
  CHECK(parts > 20);
  CHECK(dark > 20);
}

TEST_CASE("every filter's texels, with their weights, are the texture's colour") {
  for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear}) {
    const Scene scene = half_textured(filter);
    int read = 0;
    for (int x = 40; x < 120; x += 5) {
      const ExplainRequest request{x, 50, 160, 100};
      check_story(scene, request);
      for (const FragmentStory& f : explain_pixel(scene, request).fragments)
        if (f.texture) {
          ++read;
          const std::size_t texels = f.texture->texels.size();
          CHECK((filter == TextureFilter::nearest ? texels == 1 : texels >= 2 && texels <= 8));
        }
    }
    CHECK(read > 2);
  }
}

TEST_SUITE("slow") {
  TEST_CASE("the explained terms of pixels of the whole gallery add up to the frame's pixels, bit for bit") {
    for (const std::string& path : listed_scenes()) {
      CAPTURE(path);
      check_some_pixels(listed_scene(path), 16);
    }
  }
}

} // namespace refraster
