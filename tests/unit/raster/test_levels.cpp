// From linear values to the levels of an 8-bit image.

#include <refraster/render.h>

#include "tests/support/for_all.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>

using namespace refraster;

namespace {

/// The levels of an image that shows nothing but its background.
std::uint8_t level_of(double value, Transfer transfer, Precision precision) {
  Scene scene;
  scene.background = Double3(value);
  RenderOptions options;
  options.width = options.height = 1;
  options.threads = 1;
  options.transfer = transfer;
  options.precision = precision;
  return *render(scene, options).rgb8.at(0, 0);
}

/// IEC 61966-2-1.
long double srgb(long double x) {
  return x <= 0.0031308L ? 12.92L * x : 1.055L * std::pow(x, 1 / 2.4L) - 0.055L;
}

// In float the value is rounded, the curve good to an ulp or two, the product rounded: together under 4 · 2^-24 · 255.
constexpr long double undecided = 0x1p-14L;

/// For values whose scaled ones do not lie so close to a half that the precision's rounding decides.
template <class Curve>
void check_levels(Transfer transfer, const Curve& curve) {
  for (const Precision precision : {Precision::double_, Precision::float_, Precision::exact}) {
    CAPTURE(precision);
    CHECK(level_of(0, transfer, precision) == 0);
    CHECK(level_of(1, transfer, precision) == 255);
    CHECK(level_of(-0.5, transfer, precision) == 0);
    CHECK(level_of(1e300, transfer, precision) == 255);
    for_all(2000, [&](Random& random) {
      const double value = random.below(2) ? random.uniform(0, 1) : random.log_uniform(1e-4, 1e-2);
      CAPTURE(value);
      const long double scaled = 255 * curve(static_cast<long double>(value));
      const long double from_half = std::abs(scaled - std::floor(scaled) - 0.5L);
      if (from_half < undecided) return;
      REQUIRE(level_of(value, transfer, precision) == std::lround(scaled));
    });
  }
}

} // namespace

TEST_CASE("levels are 255 times the value, clamped and rounded to the nearest") {
  check_levels(Transfer::linear, [](long double x) { return x; });
}

TEST_CASE("levels with the sRGB curve are those of IEC 61966-2-1") {
  check_levels(Transfer::srgb, srgb);
}
