// The oracle of 60 digits against the slow path in long double: two texts of the same formulas that share no line.

#include "tests/scenes/half_textured.h"
#include "tests/scenes/listed_scenes.h"
#include "tests/scenes/slow_shading.h"
#include "verify/oracle/pixel_oracle.h"

#include <doctest/doctest.h>

#include <cmath>

namespace refraster {
namespace {

constexpr int width = 320, height = 180;

/// Of the slow path, as a share of the sum of all that was added up to a colour: roundings of 2^-64, of world positions
/// with magnitudes up to 2^10 that are seen from 2^-1 away or more, turn directions by at most 2^-64 2^11 2^2; and a
/// highlight, a texel or a bin of a table changes its value at most 2^10 times as fast as the direction turns. As in
/// test_colours.cpp, for another number.
constexpr slow::Real error_share = 0x1p-41L;

std::vector<slow::Pixel> chosen_pixels(int rows_apart) {
  std::vector<slow::Pixel> pixels;
  for (int y = 3; y < height; y += rows_apart)
    for (int x = 5; x < width; x += 21) pixels.push_back({x, y});
  return pixels;
}

struct Tally {
  std::size_t on_objects = 0, followed = 0;
};

Tally check_oracle(const Scene& scene, int rows_apart) {
  RenderOptions options;
  options.width = width, options.height = height;
  options.want_levels = false;
  options.aovs = {Aov::object, Aov::triangle};
  const Frame frame = render(scene, options);
  const PixelOracle oracle(scene, width, height);

  const std::vector<slow::Pixel> pixels = chosen_pixels(rows_apart);
  const auto seen = slow::seen_at(scene, width, height, pixels);
  Tally tally;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const auto x = pixels[i].x, y = pixels[i].y;
    const auto object = static_cast<std::size_t>(frame.aovs[0].at(x, y)[0]);
    const auto triangle = static_cast<std::size_t>(frame.aovs[1].at(x, y)[0]);
    if (!seen[i] || object == 0 || seen[i]->object != &scene.objects[object - 1]) continue;
    const auto expected = slow::shaded(scene, *seen[i]);
    if (!expected) continue;
    ++tally.on_objects;
    const auto found = oracle.radiance({x, y, object - 1, triangle - 1});
    if (!found) continue;
    ++tally.followed;
    CAPTURE(x);
    CAPTURE(y);
    const slow::Real values[] = {expected->radiance.x, expected->radiance.y, expected->radiance.z};
    const slow::Real sizes[] = {expected->magnitude.x, expected->magnitude.y, expected->magnitude.z};
    for (std::size_t c = 0; c < 3; ++c) {
      CAPTURE(c);
      const slow::Real exact = slow::real((*found)[c].hi) + slow::real((*found)[c].lo);
      CHECK(std::abs(exact - values[c]) <= error_share * sizes[c]);
    }
  }
  return tally;
}

void check_oracle(const std::vector<std::string>& paths, int rows_apart) {
  Tally sum;
  for (const std::string& path : paths) {
    CAPTURE(path);
    const Tally tally = check_oracle(listed_scene(path), rows_apart);
    sum.on_objects += tally.on_objects;
    sum.followed += tally.followed;
  }
  CHECK(sum.on_objects >= 100);
  CHECK(sum.followed == sum.on_objects);
}

} // namespace

TEST_CASE("the oracle of 60 digits says what the slow path in long double says") {
  check_oracle(quick_scenes(), 34);
}

TEST_CASE("so it does of a mesh of which only some triangles have texture coordinates") {
  for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear}) {
    const Tally tally = check_oracle(half_textured(filter), 17);
    CHECK(tally.followed >= 20);
    CHECK(tally.followed == tally.on_objects);
  }
}

TEST_SUITE("slow") {
  TEST_CASE("so it does in every scene of the gallery") {
    check_oracle(listed_scenes(), 17);
  }
}

} // namespace refraster
