// Textures: colours worked out by hand. Levels hold whole numbers, so that products with simple weights are exact.

#include "math/bounds/interval_functions.h"
#include "math/precisions.h"
#include "shading/texture.h"

#include <doctest/doctest.h>

#include <initializer_list>
#include <limits>
#include <random>

using namespace refraster;

namespace {

using Bounds = Interval<DoubleArithmetic>;

/// A grey image; rows from the bottom.
TextureLevel grey(int width, int height, std::initializer_list<float> texels) {
  TextureLevel level{width, height, {}};
  for (const float x : texels) level.rgb.insert(level.rgb.end(), {x, x, x});
  REQUIRE(level.rgb.size() == 3 * texels.size());
  return level;
}

/// full_scale 1, so that samples come out as stored.
Texture texture_of(TextureLevel level) {
  return {1, {std::move(level)}};
}

double at(const Texture& texture, TextureFilter filter, double u, double v, Double2 uv_dx = {}, Double2 uv_dy = {}) {
  const Rgb<double> colour = sample(texture, filter, Double2(u, v), uv_dx, uv_dy);
  REQUIRE(colour.x == colour.y);
  REQUIRE(colour.x == colour.z);
  return colour.x;
}

} // namespace

TEST_CASE("nearest takes the texel that holds the point, v upward") {
  // v = 1 is the top row of the image: the second one here.
  const Texture texture = texture_of(grey(4, 2, {0, 1, 2, 3, 10, 11, 12, 13}));
  const auto nearest = [&](double u, double v) { return at(texture, TextureFilter::nearest, u, v); };
  CHECK(nearest(0, 0) == 0);
  CHECK(nearest(0.25, 0) == 1); // a border belongs to the texel on its right
  CHECK(nearest(std::nextafter(0.25, 0), 0) == 0);
  CHECK(nearest(0.99, 0.49) == 3);
  CHECK(nearest(0.99, 0.5) == 13);
  CHECK(nearest(1, 1) == 0); // repeats
  CHECK(nearest(-1e-9, -1e-9) == 13);
  CHECK(nearest(-1e-300, 0) == 3);
}

TEST_CASE("bilinear gives each texel at its centre and the mean on borders") {
  const Texture texture = texture_of(grey(4, 2, {0, 4, 8, 12, 100, 104, 108, 112}));
  const auto bilinear = [&](double u, double v) { return at(texture, TextureFilter::bilinear, u, v); };
  CHECK(bilinear(0.125, 0.25) == 0); // (0 + 0.5) / 4, (0 + 0.5) / 2
  CHECK(bilinear(0.375, 0.25) == 4);
  CHECK(bilinear(0.875, 0.75) == 112);
  CHECK(bilinear(0.25, 0.25) == 2);
  CHECK(bilinear(0.25, 0.5) == 52);   // the mean of 0, 4, 100, 104
  CHECK(bilinear(0.1875, 0.25) == 1); // a quarter of the way from 0 to 4
  CHECK(bilinear(0, 0.25) == 6);      // the last texel of the row and the first: 12 and 0
  CHECK(bilinear(1, 0.25) == 6);
  CHECK(bilinear(0.125, 0) == 50);     // the top row and the bottom one: 100 and 0
  CHECK(bilinear(-0.0625, 0.25) == 9); // 3.75 texels - 0.5: a quarter of the way from 12 to 0
}

TEST_CASE("a texture whose sides are no powers of two repeats without a seam") {
  const Texture texture = texture_of(grey(3, 1, {0, 30, 60}));
  for (const double turn : {-7.0, -1.0, 0.0, 1.0, 2.0, 1000.0}) {
    CAPTURE(turn);
    CHECK(at(texture, TextureFilter::nearest, turn + 0.5, 0.5) == 30);
    CHECK(at(texture, TextureFilter::bilinear, turn + 0.5, 0.5) == 30);
    CHECK(at(texture, TextureFilter::bilinear, turn, 0.5) == 30); // half of 60, half of 0
  }
}

TEST_CASE("a clamped texture goes on as its edge, and one is read at uv times scale plus offset") {
  TextureMap map{std::make_shared<const Texture>(texture_of(grey(4, 2, {0, 4, 8, 12, 100, 104, 108, 112}))),
                 TextureFilter::bilinear, TextureWrap::clamp};
  const auto read = [&](double u, double v) { return sample(map, Double2(u, v), {}, {}).x; };
  CHECK(read(0.25, 0.25) == 2);
  CHECK(read(0, 0.25) == 0); // the first texel alone
  CHECK(read(-7, 0.25) == 0);
  CHECK(read(1, 0.25) == 12);
  CHECK(read(1e300, -1e300) == 12);
  CHECK(read(0.125, 9) == 100);
  map.filter = TextureFilter::nearest;
  CHECK(read(1, 1) == 112);
  CHECK(read(-0.1, 0.6) == 100);
  map = {map.texture, TextureFilter::bilinear, TextureWrap::repeat, {2, -1}, {0.5, 0.5}};
  CHECK(read(-0.125, 0.25) == 2); // at (0.25, 0.25)
  CHECK(read(0.375, 0) == 52);    // at (1.25, 0.5), which is (0.25, 0.5): the mean of 0, 4, 100, 104
}

TEST_CASE("a texture of one texel is that colour everywhere") {
  Texture texture = texture_of(grey(1, 1, {7}));
  for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear})
    for (const double u : {0.0, 0.3, -1e-9, 1e7, -12345.678, 1e300})
      CHECK(at(texture, filter, u, -u, {3, 0}, {0, 3}) == 7);
}

TEST_CASE("far from the origin a texture is as sharp as the coordinate is") {
  TextureLevel ramp{1024, 1, {}};
  for (int x = 0; x < 1024; ++x) ramp.rgb.insert(ramp.rgb.end(), 3, static_cast<float>(x));
  const Texture texture = texture_of(std::move(ramp));
  // 10^7 + 1/4 and its kin are exact in double, and so is the product with 1024: texel 256 begins there.
  for (const double turn : {1e7, -1e7, 1e9, -1e9, 0x1p30, 0x1p40, -0x1p40}) {
    CAPTURE(turn);
    CHECK(at(texture, TextureFilter::nearest, turn + 0.25, 0.5) == 256);
    CHECK(at(texture, TextureFilter::bilinear, turn + 0.25, 0.5) == 255.5);
    CHECK(at(texture, TextureFilter::bilinear, turn + 0.75, 0.5) == 767.5);
  }
  CHECK(at(texture, TextureFilter::bilinear, -1e-9, 0.5) == doctest::Approx(511.5).epsilon(1e-5)); // 1023 and 0
  CHECK(at(texture, TextureFilter::nearest, -1e-9, 0.5) == 1023);
}

TEST_CASE_TEMPLATE("a coordinate that is not finite counts as 0", F, double, float) {
  const Texture texture = texture_of(grey(2, 2, {1, 2, 4, 8}));
  const F infinity = std::numeric_limits<F>::infinity(), nan = std::numeric_limits<F>::quiet_NaN();
  for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear}) {
    const auto red = [&](F u, F v, F step) { return sample(texture, filter, {u, v}, Vec2<F>(step), Vec2<F>(step)).x; };
    const F at_zero = red(0, 0, 0);
    for (const F bad : {infinity, -infinity, nan}) {
      CHECK(red(bad, 0, 0) == at_zero);
      CHECK(red(0, bad, 0) == at_zero);
      CHECK(red(bad, bad, bad) == at_zero);
    }
  }
}

TEST_CASE("stored values are divided by full scale at the end") {
  Texture texture{255, {grey(2, 1, {255, 51})}};
  CHECK(at(texture, TextureFilter::nearest, 0, 0) == 1);
  CHECK(at(texture, TextureFilter::bilinear, 0.75, 0) == 51 / 255.0);
  CHECK(at(texture, TextureFilter::bilinear, 0.5, 0) == 153 / 255.0); // not 1 / 2 + 51 / 255 / 2, rounded twice
}

TEST_CASE("a mip level is the mean of the area below") {
  Texture texture = texture_of(grey(4, 2, {0, 4, 8, 12, 100, 104, 108, 112}));
  build_mip_levels(texture);
  REQUIRE(texture.levels.size() == 3); // 4 x 2, 2 x 1, 1 x 1
  CHECK(texels_of<double>(texture.levels[1])(0, 0, 0).x == 52);
  CHECK(texels_of<double>(texture.levels[1])(1, 0, 0).x == 60);
  CHECK(texels_of<double>(texture.levels[2])(0, 0, 0).x == 56);

  Texture odd = texture_of(grey(5, 1, {10, 20, 30, 40, 50}));
  build_mip_levels(odd);
  REQUIRE(odd.levels.size() == 3); // 5, 2, 1
  REQUIRE(odd.levels[1].width == 2);
  CHECK(texels_of<double>(odd.levels[1])(0, 0, 0).x == 18); // (10 + 20 + 30 / 2) / 2.5
  CHECK(texels_of<double>(odd.levels[1])(1, 0, 0).x == 42); // (30 / 2 + 40 + 50) / 2.5
  CHECK(texels_of<double>(odd.levels[2])(0, 0, 0).x == 30);
}

TEST_CASE("every mip level has the mean of the image, whatever its size") {
  std::mt19937 random(1);
  for (const auto& [width, height] : {std::pair(7, 3), std::pair(1, 9), std::pair(13, 6), std::pair(64, 1)}) {
    TextureLevel level{width, height, {}};
    double mean = 0;
    for (int k = 0; k < width * height; ++k) {
      const auto value = static_cast<float>(random() % 256);
      level.rgb.insert(level.rgb.end(), 3, value);
      mean += static_cast<double>(value) / (width * height);
    }
    Texture texture = texture_of(std::move(level));
    build_mip_levels(texture);
    CHECK(texture.levels.back().rgb.size() == 3);
    // Each of up to six levels rounds a mean of at most 256 to float: by 2^-17.
    for (const TextureLevel& smaller : texture.levels) {
      double sum = 0;
      for (std::size_t k = 0; k < smaller.rgb.size(); k += 3) sum += static_cast<double>(smaller.rgb[k]);
      CHECK(std::abs(sum / (smaller.width * smaller.height) - mean) <= 6 * 0x1p-17);
    }
  }
}

TEST_CASE("trilinear chooses the levels as OpenGL does") {
  // Three levels, 4 x 4, 2 x 2 and 1 x 1, each of one colour, so that the result shows the shares of the levels.
  Texture texture = texture_of(grey(4, 4, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
  texture.levels.push_back(grey(2, 2, {100, 100, 100, 100}));
  texture.levels.push_back(grey(1, 1, {200}));
  const auto trilinear = [&](Double2 uv_dx, Double2 uv_dy) {
    return at(texture, TextureFilter::trilinear, 0.3, 0.7, uv_dx, uv_dy);
  };
  CHECK(trilinear({0.25, 0}, {0, 0.25}) == 0); // a pixel is 1 texel: lambda = 0
  CHECK(trilinear({0.1, 0}, {0, 0.1}) == 0);   // magnified
  CHECK(trilinear({0, 0}, {0, 0}) == 0);       // log2(0)
  CHECK(trilinear({0.5, 0}, {0, 0.1}) == 100); // 2 texels: lambda = 1
  CHECK(trilinear({0.3, 0.4}, {0, 0}) == 100); // the length of (1.2, 1.6) texels is 2
  CHECK(trilinear({0, 0.1}, {1, 0}) == 200);   // the longer side counts: 4 texels, lambda = 2
  CHECK(trilinear({9, 0}, {0, 9}) == 200);     // no smaller level
  CHECK(trilinear({std::sqrt(0.125), 0}, {0, 0}) == doctest::Approx(50));    // sqrt(2) texels: lambda = 1/2
  CHECK(trilinear({0.5 * std::sqrt(2), 0}, {0, 0}) == doctest::Approx(150)); // lambda = 3/2
  CHECK(trilinear({0.375, 0}, {0, 0}) == doctest::Approx(100 * std::log2(1.5)));
}

TEST_CASE("trilinear measures a pixel in texels of each side's own size") {
  Texture texture = texture_of(grey(8, 2, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
  texture.levels.push_back(grey(4, 1, {100, 100, 100, 100}));
  texture.levels.push_back(grey(2, 1, {200, 200}));
  CHECK(at(texture, TextureFilter::trilinear, 0, 0, {0, 0}, {0, 1}) == 100);   // 2 texels upward
  CHECK(at(texture, TextureFilter::trilinear, 0, 0, {0.5, 0}, {0, 1}) == 200); // 4 texels to the right
}

TEST_CASE("trilinear without smaller levels is bilinear") {
  const Texture texture = texture_of(grey(4, 2, {0, 4, 8, 12, 100, 104, 108, 112}));
  CHECK(at(texture, TextureFilter::trilinear, 0.25, 0.5, {9, 9}, {9, 9}) == 52);
}

TEST_CASE_TEMPLATE("every lane samples a texture as it would alone", F, double, float) {
  std::mt19937 random(2);
  TextureLevel level{13, 6, {}};
  for (int k = 0; k < 3 * 13 * 6; ++k) level.rgb.push_back(static_cast<float>(random() % 256));
  Texture texture{255, {level}};
  build_mip_levels(texture);
  std::uniform_real_distribution<F> uniform(-3, 3), log_step(-12, 3);
  using T = Native<F>;
  for (int trial = 0; trial < 2000; ++trial) {
    Vec2<T> uv, uv_dx, uv_dy;
    for (int lane = 0; lane < NumberTraits<T>::lanes; ++lane) {
      uv.x.set(lane, uniform(random)), uv.y.set(lane, 10000 * uniform(random));
      uv_dx.x.set(lane, std::exp2(log_step(random))), uv_dx.y.set(lane, std::exp2(log_step(random)));
      uv_dy.x.set(lane, std::exp2(log_step(random))), uv_dy.y.set(lane, std::exp2(log_step(random)));
    }
    for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear}) {
      const Rgb<T> together = sample(texture, filter, uv, uv_dx, uv_dy);
      for (int lane = 0; lane < NumberTraits<T>::lanes; ++lane) {
        const auto of_lane = [&](const Vec2<T>& a) { return Vec2<F>(a.x[lane], a.y[lane]); };
        const Rgb<F> alone = sample(texture, filter, of_lane(uv), of_lane(uv_dx), of_lane(uv_dy));
        REQUIRE(together.x[lane] == alone.x);
        REQUIRE(together.y[lane] == alone.y);
        REQUIRE(together.z[lane] == alone.z);
      }
    }
  }
}

TEST_CASE("bounds on a box of coordinates contain every sample in it") {
  std::mt19937_64 random(3);
  TextureLevel level{13, 6, {}};
  for (int k = 0; k < 3 * 13 * 6; ++k) level.rgb.push_back(static_cast<float>(random() % 256));
  Texture texture{255, {level}};
  build_mip_levels(texture);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 2000; ++trial) {
    // Boxes smaller than a texel, as large as several, and across the seams.
    const double size = std::exp2(-12 + 10 * std::abs(uniform(random)));
    const Double2 middle(2 * uniform(random), 2 * uniform(random)), dx(0.2 * uniform(random), 0), dy(0, 0.2);
    const auto box = [&](double x) { return Bounds(x - size, x + size); };
    const Vec2<Bounds> uv(box(middle.x), box(middle.y)), uv_dx(Bounds(dx.x), Bounds(0.0)),
        uv_dy(Bounds(0.0), Bounds(dy.y));
    for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear}) {
      const Rgb<Bounds> bounds = sample(texture, filter, uv, uv_dx, uv_dy);
      for (int k = 0; k < 4; ++k) {
        const Double2 inside(middle.x + size * uniform(random), middle.y + size * uniform(random));
        const Rgb<double> point = sample(texture, filter, inside, dx, dy);
        REQUIRE(bounds.x.contains(point.x));
        REQUIRE(bounds.y.contains(point.y));
        REQUIRE(bounds.z.contains(point.z));
      }
    }
  }
}
