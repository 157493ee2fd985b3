// Every scene against a second renderer that shares no arithmetic with the first: tests/support/slow/slow_visibility.h
// and slow_shading.h.

#include "tests/support/scenes/declared_scenes.h"
#include "tests/support/scenes/half_textured.h"
#include "tests/support/scenes/leaf_scene.h"
#include "tests/support/scenes/listed_scenes.h"
#include "tests/support/scenes/shadow_scene.h"
#include "tests/support/slow/slow_shading.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

namespace refraster {
namespace {

/// Of the double precision, as a fraction of the sum of all that was added up to a colour.
///   2^-24   the value is rounded to float at the very end
///   2^-30   before that, it is computed in double. World positions have magnitudes up to 2^10 and are seen from 2^-1
///           away or more: their few roundings of 2^-53 turn directions by at most 2^-53 2^11 2^2 = 2^-40. A highlight,
///           a texel or a bin of a table changes its value at most 2^10 times as fast as the direction turns (exponents
///           here are at most 220, tables have 90 bins in a quarter turn and change by less than a factor 2^3 a bin).
constexpr slow::Real error_fraction = 0x1p-24L + 0x1p-30L;
/// Beside that, near 0: half of the smallest float.
constexpr slow::Real error_near_zero = 0x1p-150L;

constexpr int width = 320, height = 180;

/// Off the axes of symmetry, where edges like to lie.
std::vector<slow::Pixel> chosen_pixels(int rows_apart) {
  std::vector<slow::Pixel> pixels;
  for (int y = 4; y < height; y += rows_apart)
    for (int x = 7; x < width; x += 23) pixels.push_back({x, y});
  return pixels;
}

/// The level that a value becomes; nothing where an error of `error` decides between two.
std::optional<int> level_of_value(slow::Real value, slow::Real error) {
  const slow::Real in_range = std::fmin(std::fmax(value, 0), 1);
  const slow::Real low = std::nearbyint(255 * (in_range - error)), high = std::nearbyint(255 * (in_range + error));
  if (low != high) return std::nullopt;
  return static_cast<int>(low);
}

void check_colours(const Scene& scene, int rows_apart) {
  const std::vector<slow::Pixel> pixels = chosen_pixels(rows_apart);
  RenderOptions options;
  options.width = width, options.height = height;
  options.want_radiance = true;
  options.aovs = {Aov::object, Aov::position, Aov::normal};
  const Frame frame = render(scene, options);

  const auto seen = slow::seen_at(scene, width, height, pixels);
  std::size_t judged = 0, on_objects = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (!seen[i]) continue;
    const int x = pixels[i].x, y = pixels[i].y;
    CAPTURE(x);
    CAPTURE(y);
    const float object = seen[i]->object ? static_cast<float>(seen[i]->object - scene.objects.data() + 1) : 0.0f;
    CHECK(frame.aovs[0].at(x, y)[0] == object);
    if (frame.aovs[0].at(x, y)[0] != object) continue;

    const auto shaded = slow::shaded(scene, *seen[i]);
    if (!shaded) continue;
    ++judged;
    if (seen[i]->object) ++on_objects;
    const std::array<slow::Real, 3> expected = {shaded->radiance.x, shaded->radiance.y, shaded->radiance.z};
    const std::array<slow::Real, 3> size = {shaded->magnitude.x, shaded->magnitude.y, shaded->magnitude.z};
    for (std::size_t c = 0; c < 3; ++c) {
      CAPTURE(c);
      const slow::Real error = error_fraction * size[c] + error_near_zero;
      CHECK(std::abs(slow::real(frame.radiance.at(x, y)[c]) - expected[c]) <= error);
      if (const auto level = level_of_value(expected[c], error)) CHECK(int{frame.rgb8.at(x, y)[c]} == *level);
    }
  }
  // Nearly all are judged: what the slow path leaves out are a few pixels on edges, and one of three panels of the
  // scene that shows lookups.
  CHECK(judged * 10 >= pixels.size() * 8);
  CHECK(on_objects >= 5);
}

void check_colours(const std::vector<std::string>& paths, int rows_apart) {
  for (const std::string& path : paths) {
    CAPTURE(path);
    check_colours(listed_scene(path), rows_apart);
  }
}

} // namespace

TEST_CASE("at chosen pixels, colours are those of a ray of long doubles and the textbook's formulas") {
  check_colours(quick_scenes(), 38);
}

TEST_CASE("so they are of a mesh of which only some triangles have texture coordinates") {
  for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear})
    check_colours(half_textured(filter), 19);
}

TEST_CASE("so they are where surfaces are cut out by their opacity") {
  for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear})
    check_colours(leaf_scene(filter), 7);
}

TEST_CASE("so they are where other things take a light") {
  check_colours(shadow_scene(), 7);
}

TEST_CASE("so they are with every type of light, texture slot and vertex attribute") {
  for (const DeclaredEntry& entry : declared_entries()) {
    INFO("slow_shading.cpp and slow_visibility.cpp may not know " << entry.name);
    check_colours(entry.with, 38);
  }
}

TEST_SUITE("slow") {
  TEST_CASE("so they are in every scene of the gallery") {
    check_colours(listed_scenes(), 38);
  }
}

TEST_SUITE("long") {
  TEST_CASE("so they are in more rows of them") {
    check_colours(listed_scenes(), 5);
  }
}

} // namespace refraster
