// How fine the picture is while the camera moves.

#include "app/view/pacing.h"

#include <doctest/doctest.h>

#include <utility>

using namespace refraster;

namespace {

/// The scale after many frames of a scene whose frames take so long, for vertices and at full size for pixels.
double settled_scale(double fixed_seconds, double full_seconds, Pacing pacing = {}) {
  for (int i = 0; i < 100; ++i) {
    const double tiles = full_seconds * pacing.scale() * pacing.scale();
    pacing.add({.bin = fixed_seconds, .tiles = tiles, .total = fixed_seconds + tiles}, 0);
  }
  return pacing.scale();
}

} // namespace

TEST_CASE("the scale is the finest at which thirty frames a second are made") {
  CHECK(settled_scale(0, 0.001) == 1);
  CHECK(settled_scale(0, 0.045) == 0.75); // 45 ms, and at three quarters 25 ms
  CHECK(settled_scale(0, 0.1) == 0.5);    // 25 ms
  CHECK(settled_scale(0, 1) == 1.0 / 8);  // 16 ms, and at 3/16 35 ms
  CHECK(settled_scale(0, 1000) == moving_scales.back());
}

TEST_CASE("what does not depend on the pixels is not made less by fewer of them") {
  CHECK(settled_scale(0.020, 0.004) == 1);
  CHECK(settled_scale(0.025, 0.02) == 0.5); // 30 ms
  CHECK(settled_scale(0.030, 0.02) == 0.5); // 35 ms, of which pixels are 5
  CHECK(settled_scale(1, 0.001) == 1);      // coarser ones would be as slow
  CHECK(settled_scale(0.04, 0.04) == 0.5);  // 10 ms for pixels
  CHECK(settled_scale(1, 100) == moving_scales.back());
}

TEST_CASE("the scale does not go to and fro") {
  for (int full = 1; full < 400; ++full) {
    Pacing pacing;
    int changes = 0;
    double before = pacing.scale();
    for (int i = 0; i < 200; ++i) {
      const double noise = i % 2 == 0 ? 1.03 : 0.97;
      const double tiles = 1e-3 * full * noise * pacing.scale() * pacing.scale();
      pacing.add({.tiles = tiles, .total = tiles}, 0);
      changes += pacing.scale() != before;
      before = pacing.scale();
    }
    INFO(full << " ms");
    CHECK(changes <= static_cast<int>(moving_scales.size())); // each is passed once at most
  }
}

TEST_CASE("a scene that becomes lighter is drawn finer again, and showing counts") {
  Pacing pacing;
  for (int i = 0; i < 100; ++i) pacing.add({.tiles = 1, .total = 1}, 0);
  CHECK(pacing.scale() == moving_scales.back());
  CHECK(settled_scale(0, 0.001, pacing) == 1);
  Pacing quick_display, slow_display;
  for (int i = 0; i < 100; ++i)
    for (auto [of_display, showing_seconds] : {std::pair{&quick_display, 0.0}, std::pair{&slow_display, 0.02}}) {
      const double tiles = 0.04 * of_display->scale() * of_display->scale();
      of_display->add({.tiles = tiles, .total = tiles}, showing_seconds);
    }
  CHECK(quick_display.scale() == 0.75); // 22.5 ms
  CHECK(slow_display.scale() == 0.5);   // 10 ms and 20 ms
}
