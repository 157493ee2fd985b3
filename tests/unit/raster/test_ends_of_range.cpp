// Frames of scenes whose numbers are near the ends of a precision's range.

#include "tests/support/raster/window_scene.h"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>

namespace refraster::test {

TEST_CASE("where a centre lies on the line at which a triangle's plane vanishes, texture coordinates are finite") {
  // Corners on the lattice. Sample 0 of 2 is covered, and at the centre the weights add up to exactly 0.
  WindowScene window(8);
  window.add({window.place(.5, 1, 1), window.place(.75, .625, 4), window.place(1, 1, 1)}, Double3(1),
             {{0, 0}, {1, 0}, {.5f, 1}});
  const Frame frame = window.frame({Aov::object, Aov::uv}, 2);
  CHECK(frame.aovs[0].at(0, 0)[0] == 1);
  for (const float uv : frame.aovs[1].values) CHECK(std::isfinite(uv));
}

TEST_CASE("on the edge opposite a corner next to the eye, what is seen is that edge, in every precision") {
  // Of 1 / w the two that count have less than 2^-70 of the third's, which on their edge has no part.
  for (const Precision precision : {Precision::double_, Precision::float_, Precision::fast}) {
    CAPTURE(precision);
    WindowScene window(32, 0x1p-110);
    Object& object = window.add({window.place(4, 8.5, 2), window.place(28, 8.5, 2), window.place(16, 30, 1e-22)},
                                Double3(1), {{0.375f, 0.375f}, {0.375f, 0.375f}, {0.375f, 0.375f}});
    auto texture = std::make_shared<Texture>();
    texture->full_scale = 1;
    texture->levels.push_back({1, 1, {0.5f, 0.5f, 0.5f}});
    object.material.diffuse_map.texture = texture;
    RenderOptions options = window.options({Aov::object});
    options.precision = precision;
    const Frame frame = render(window.scene, options);
    CHECK(frame.counts.undefined[Undefined::bad_uv] == 0);
    CHECK(frame.counts.undefined[Undefined::not_finite] == 0);
    int shown = 0;
    for (int x = 4; x < 28; ++x) {
      if (frame.aovs[0].at(x, 8)[0] == 0) continue;
      ++shown;
      CHECK(frame.radiance.at(x, 8)[0] == 0.5f);
    }
    CHECK(shown > 20);
  }
}

TEST_CASE("a light too bright for a precision is as bright as that can be, and does no harm where it does not reach") {
  for (const Precision precision : {Precision::double_, Precision::float_, Precision::fast}) {
    CAPTURE(precision);
    WindowScene window(8);
    window.add({window.place(-8, -8, 1), window.place(24, -8, 1), window.place(-8, 24, 1)}, Double3(0.5));
    window.scene.direction_lights = {{{0, 0, 1}, Double3(1e39)}}; // from behind
    RenderOptions options = window.options();
    options.precision = precision;
    const Frame frame = render(window.scene, options);
    CHECK(frame.counts.undefined[Undefined::not_finite] == 0);
    for (const float value : frame.radiance.values) CHECK(value == 0.5f);
  }
}

TEST_CASE("a far plane near the largest number still has all before it") {
  WindowScene window(8, 0.25, 1e308);
  window.add({window.place(-8, -8, 1), window.place(24, -8, 1), window.place(-8, 24, 1)});
  CHECK(window.frame().counts.shaded == 64);
}

} // namespace refraster::test
