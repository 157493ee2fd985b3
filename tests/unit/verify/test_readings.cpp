// What a filter or a lookup reads, with its weights, worked out by hand.

#include "verify/explain/readings.h"

#include <refraster/fragment_kit.h>

#include "tests/support/shading/merl_tables.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <memory>

namespace {

using namespace refraster;

TEST_CASE("texels that a filter reads have the weights of the filter") {
  Texture texture{255, {TextureLevel{2, 2, {}}}};
  const auto read_by = [&](TextureFilter filter, const Double2& uv, const Double2& right, const Double2& down) {
    return texels_read({.texture = std::make_shared<const Texture>(texture), .filter = filter}, uv, right, down);
  };
  for (const float grey : {10.f, 20.f, 30.f, 40.f}) // (0, 0), (1, 0), (0, 1), (1, 1)
    for (int c = 0; c < 3; ++c) texture.levels[0].rgb.push_back(grey);
  build_mip_levels(texture);
  const Double2 nothing(0);
  // In texels (0.8, 1.3), less the half of the first: 0.3 of the way from column 0 to 1, 0.8 from row 0 to 1.
  std::vector<Texel> texels = read_by(TextureFilter::bilinear, {0.4, 0.65}, nothing, nothing);
  REQUIRE(texels.size() == 4);
  constexpr double weights[] = {0.7 * 0.2, 0.3 * 0.2, 0.7 * 0.8, 0.3 * 0.8};
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(texels[k].i == static_cast<int>(k % 2));
    CHECK(texels[k].j == static_cast<int>(k / 2));
    CHECK(texels[k].weight == doctest::Approx(weights[k]));
    CHECK(texels[k].value.x == doctest::Approx(10.0 * static_cast<double>(k + 1) / 255));
  }
  texels = read_by(TextureFilter::nearest, {-0.3, 0.2}, nothing, nothing); // column -1 is column 1
  REQUIRE(texels.size() == 1);
  CHECK(texels[0].i == 1);
  CHECK(texels[0].j == 0);
  CHECK(texels[0].weight == doctest::Approx(1));
  // A pixel of sqrt 2 texels: half of it from either level. Level 1 has one texel, which all four corners are.
  texels = read_by(TextureFilter::trilinear, {0.4, 0.65}, {std::sqrt(0.5), 0}, nothing);
  REQUIRE(texels.size() == 5);
  for (std::size_t k = 0; k < 4; ++k) CHECK(texels[k].weight == doctest::Approx(weights[k] / 2));
  CHECK(texels[4].level == 1);
  CHECK(texels[4].weight == doctest::Approx(0.5));
  CHECK(texels[4].value.x == doctest::Approx(25.0 / 255));
}

TEST_CASE("texels beyond a clamped edge are those of the edge, by every filter") {
  TextureLevel level{4, 4, {}};
  for (int k = 0; k < 16; ++k)
    for (int c = 0; c < 3; ++c) level.rgb.push_back(static_cast<float>(k));
  Texture texture{255, {level}};
  build_mip_levels(texture);
  TextureMap map{.texture = std::make_shared<const Texture>(texture)};
  map.wrap = TextureWrap::clamp;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear}) {
    map.filter = filter;
    const auto only_texel = [&](const Double2& uv, int i, int j) {
      CAPTURE(uv.x);
      CAPTURE(uv.y);
      const std::vector<Texel> texels = texels_read(map, uv, Double2(0), Double2(0));
      REQUIRE(texels.size() == 1);
      CHECK(texels[0].i == i);
      CHECK(texels[0].j == j);
      CHECK(texels[0].weight == doctest::Approx(1));
    };
    only_texel({-1.5, -2}, 0, 0);
    only_texel({2.5, -1e300}, 3, 0);
    only_texel({-infinite, infinite}, 0, 3);
    only_texel({nan, 7}, 0, 3); // as the frame has it
    // Beyond one edge only: along the other axis the filter goes on.
    double weight = 0;
    for (const Texel& texel : texels_read(map, {0.4, 3}, Double2(0), Double2(0))) {
      CHECK(texel.j == 3);
      weight += texel.weight;
    }
    CHECK(weight == doctest::Approx(1));
  }
}

TEST_CASE("taps of a table have the weights of the lookup; what was never measured has none, and says so") {
  const auto table = table_of([](int h, int d, int p) {
    if (h == 10 && d == 20 && p == 30) return Rgb<double>(-1);
    return Rgb<double>(h, d, p);
  });
  // 0.25, 0.5 and 0.75 of the way beyond the centres of bins 10, 20 and 30.
  const MerlPoint<double> at{10.75, 21, 31.25};
  double sum = 0;
  std::vector<MerlTap> taps = taps_read(*table, MerlLookup::trilinear, at);
  REQUIRE(taps.size() == 8);
  for (const MerlTap& tap : taps) {
    const double weight = (tap.theta_h == 10 ? 0.75 : 0.25) * 0.5 * (tap.phi_d == 30 ? 0.25 : 0.75);
    const bool missing = tap.theta_h == 10 && tap.theta_d == 20 && tap.phi_d == 30;
    CHECK(tap.unmeasured == missing);
    CHECK(tap.weight == doctest::Approx(missing ? 0 : weight / (1 - 0.75 * 0.5 * 0.25)));
    sum += tap.weight;
  }
  CHECK(sum == doctest::Approx(1));
  taps = taps_read(*table, MerlLookup::nearest, at);
  REQUIRE(taps.size() == 1);
  CHECK(taps[0].theta_d == 21);
  for (const MerlLookup lookup : {MerlLookup::trilinear_log, MerlLookup::tricubic_log}) {
    sum = 0;
    for (const MerlTap& tap : taps_read(*table, lookup, {50.25, 50.5, 50.75})) sum += tap.weight;
    CHECK(sum == doctest::Approx(1));
  }
  CHECK(taps_read(*table, MerlLookup::tricubic_log, {50.25, 50.5, 50.75}).size() == 64);
}

} // namespace
