// The extremes (docs/extremes.md), rows I: interpolation.

#include "shading/texture.h"
#include "tests/support/for_all.h"
#include "tests/support/raster/window_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

using namespace refraster;
using namespace refraster::test;

namespace {

// A texture of one level whose texel (i, j) is of colour (i, j, 0), j counted upward.
std::shared_ptr<const Texture> index_texture(int width, int height) {
  auto texture = std::make_shared<Texture>();
  texture->full_scale = 1;
  TextureLevel level{width, height, {}};
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i)
      for (const int value : {i, j, 0}) level.rgb.push_back(static_cast<float>(value));
  texture->levels.push_back(std::move(level));
  return texture;
}

template <class T>
Rgb<T> look_up(const Texture& texture, TextureFilter filter, double u, double v) {
  const Vec2<T> still(T(0), T(0));
  return sample(texture, filter, Vec2<T>(static_cast<T>(u), static_cast<T>(v)), still, still);
}

// Floor and remainder of u n in rational numbers.
struct ExactCell {
  std::int64_t index;
  Rational fraction;
};
ExactCell exact_cell(const Rational& x) {
  const Integer n = numerator(x), d = denominator(x);
  Integer q = n / d;
  if (n < 0 && q * d != n) q -= 1;
  return {static_cast<std::int64_t>(q), x - Rational(q)};
}
int wrapped(std::int64_t i, int n) {
  return static_cast<int>((i % n + n) % n);
}

} // namespace

TEST_CASE("I1: an attribute that is the same at three corners comes out bit for bit") {
  for_all(60, [](Random& random) {
    WindowScene window(16);
    std::vector<Float3> corner;
    const Float2 uv(static_cast<float>(random.sign() * random.log_uniform(1e-30, 1e6)),
                    static_cast<float>(random.uniform(-2, 2)));
    for (int k = 0; k < 3; ++k)
      corner.emplace_back(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 1));
    const float z = static_cast<float>(-random.log_uniform(0.5, 500));
    const bool upright = random.below(2) == 0;
    if (upright)
      for (Float3& p : corner) p.z = z;
    window.add(corner, Double3(1), {uv, uv, uv});
    const Frame frame = window.frame({Aov::object, Aov::uv, Aov::position, Aov::normal});
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        if (!is_drawn(frame, x, y)) continue;
        REQUIRE(frame.aovs[1].at(x, y)[0] == uv.x);
        REQUIRE(frame.aovs[1].at(x, y)[1] == uv.y);
        if (upright) REQUIRE(frame.aovs[2].at(x, y)[2] == z);
        REQUIRE(frame.aovs[3].at(x, y)[2] == 1);
      }
  });
}

TEST_CASE("I2: with distances of 1 to 1e8 among its corners, a triangle is good to an ulp of the image's float") {
  double worst = 0;
  for (const double ratio : {1.0, 1e2, 1e4, 1e6, 1e8})
    for_all(20, [&](Random& random) {
      CAPTURE(ratio);
      WindowScene window(16, 0.25, 1e12);
      // On the lattice: snapping moves nothing. Of the three corners one or two are far away.
      const double far = std::exp2(std::round(std::log2(ratio)));
      std::vector<Float3> corner;
      for (const auto& [x, y] : {std::pair(0, 0), std::pair(16, 2), std::pair(4, 16)})
        corner.push_back(window.place(x + random.below(4) - 1, y + random.below(4) - 1, 1));
      for (int k = 0; k <= random.below(2); ++k) {
        Float3& p = corner[static_cast<std::size_t>(random.below(3))];
        if (p.z == -1) p = p * static_cast<float>(far);
      }
      // The texture coordinates grow with distance, as those of a ground plane do.
      std::vector<Float2> uvs;
      for (const Float3& p : corner) uvs.emplace_back(0.5f * p.z, p.x);
      window.add(corner, Double3(1), uvs);
      const Frame frame = window.frame({Aov::object, Aov::uv, Aov::position});
      const ExactTriangle truth = window.exact_triangle(corner[0], corner[1], corner[2]);
      for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
          if (!is_drawn(frame, x, y)) continue;
          const auto at = truth.at(x * 256 + 128, y * 256 + 128);
          REQUIRE(at);
          const Mpfr distance = -exact(at->weight[0] * Rational(corner[0].z) + at->weight[1] * Rational(corner[1].z) +
                                       at->weight[2] * Rational(corner[2].z));
          // Relative to the size of the point seen, which is its distance: no coordinate in view is larger, and one
          // that passes through 0 has no digits of its own.
          const Mpfr ulp = 2 * half_float_ulp(distance);
          const auto check = [&](std::size_t aov, int channel, const auto& value) {
            Mpfr expected = 0;
            for (std::size_t k = 0; k < 3; ++k) expected += exact(at->weight[k] * Rational(value(k)));
            const double error =
                Mpfr(abs(Mpfr(frame.aovs[aov].at(x, y)[channel]) - expected) / ulp).template convert_to<double>();
            worst = std::max(worst, error);
            REQUIRE(error <= 1);
          };
          for (int c = 0; c < 3; ++c) check(2, c, [&](std::size_t k) { return corner[k][c]; });
          for (int c = 0; c < 2; ++c) check(1, c, [&](std::size_t k) { return uvs[k][c]; });
        }
    });
  MESSAGE("largest error: " << worst << " ulp");
}

TEST_CASE(
    "I3: a triangle of four pixels in the far corner of the largest image, attribute 1e6 +- 1, is good to an ulp") {
  WindowScene window(16384);
  for_all(20, [&](Random& random) {
    WindowScene one = window;
    std::vector<Float3> corner;
    std::vector<Float2> uvs;
    for (int k = 0; k < 3; ++k) {
      // Places in 24 bits: within a quarter pixel of any.
      const auto coordinate = [&] { return 16378 + random.below(4 * 5) / 4.0; };
      const double x = coordinate(), y = coordinate();
      corner.push_back(one.place(x, y, std::exp2(random.below(3))));
      uvs.emplace_back(static_cast<float>(1e6 + random.below(33) / 16.0 - 1),
                       static_cast<float>(random.below(33) / 16.0 - 1));
    }
    one.add(corner, Double3(1), uvs);
    const ExactTriangle truth = one.exact_triangle(corner[0], corner[1], corner[2]);
    RenderOptions options = one.options({Aov::object, Aov::uv});
    options.crop = PixelRect{16376, 16376, 8, 8};
    const Frame frame = render(one.scene, options);
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x) {
        if (!is_drawn(frame, x, y)) continue;
        const auto at = truth.at((16376 + x) * 256 + 128, (16376 + y) * 256 + 128);
        REQUIRE(at);
        for (int c = 0; c < 2; ++c) {
          Mpfr expected = 0;
          for (std::size_t k = 0; k < 3; ++k) expected += exact(at->weight[k] * Rational(uvs[k][c]));
          const Mpfr ulp = c == 0 ? 2 * half_float_ulp(expected) : 2 * half_float_ulp(Mpfr(1));
          REQUIRE(abs(Mpfr(frame.aovs[1].at(x, y)[c]) - expected) <= ulp);
        }
      }
  });
}

TEST_CASE("I4: an interpolated value lies between the values at the corners") {
  long on_edges = 0;
  for_all(400, [&](Random& random) {
    WindowScene window(16);
    std::vector<Float3> corner;
    std::vector<Float2> uvs;
    float least[2] = {INFINITY, INFINITY}, most[2] = {-INFINITY, -INFINITY};
    for (int k = 0; k < 3; ++k) {
      // Half of the corners on sample centres, so that edges run through centres, where a share is 0.
      const auto coordinate = [&] { return random.below(24) - 4 + 0.5; };
      const double x = coordinate(), y = coordinate();
      corner.push_back(window.place(x, y, std::exp2(random.below(4))));
      const float some[] = {0, 0, 1, static_cast<float>(random.uniform(0, 1)),
                            static_cast<float>(random.uniform(-1e-3, 1e-3))};
      uvs.emplace_back(some[random.below(5)], some[random.below(5)]);
      for (int c = 0; c < 2; ++c)
        least[c] = std::min(least[c], uvs.back()[c]), most[c] = std::max(most[c], uvs.back()[c]);
    }
    window.add(corner, Double3(1), uvs);
    const ExactTriangle truth = window.exact_triangle(corner[0], corner[1], corner[2]);
    const Frame frame = window.frame({Aov::object, Aov::uv});
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        if (!is_drawn(frame, x, y)) continue;
        const auto at = truth.at(x * 256 + 128, y * 256 + 128);
        on_edges += at->how == Meets::border;
        for (int c = 0; c < 2; ++c) {
          REQUIRE(frame.aovs[1].at(x, y)[c] >= least[c]);
          REQUIRE(frame.aovs[1].at(x, y)[c] <= most[c]);
          Rational expected = 0;
          for (std::size_t k = 0; k < 3; ++k) expected += at->weight[k] * Rational(uvs[k][c]);
          REQUIRE(abs(Mpfr(frame.aovs[1].at(x, y)[c]) - exact(expected)) <=
                  half_float_ulp(exact(expected)) + interpolation_bound(Mpfr(1)));
        }
      }
  });
  CHECK(on_edges > 100);
}

TEST_CASE("I4: on an edge where the texture coordinate is 0 the first texel is seen, not the last") {
  // Quads with sides through sample centres; the coordinate is 0 along the top and the left side, which own them. The
  // exact value there is 0: rounding must not make it negative.
  const auto nearest_texels = [](WindowScene& window, Object& object) {
    object.material.diffuse_map.texture = index_texture(4, 4);
    object.material.diffuse_map.filter = TextureFilter::nearest;
    std::vector<Frame> frames;
    for (const Precision precision : {Precision::double_, Precision::float_}) {
      RenderOptions options = window.options();
      options.precision = precision;
      frames.push_back(render(window.scene, options));
    }
    return frames;
  };
  long wrong = 0, seen = 0;
  for_all(200, [&](Random& random) {
    WindowScene window(32);
    const double x0 = random.below(8) + 0.5, y0 = random.below(8) + 0.5, x1 = 20 + random.below(12) + 0.5,
                 y1 = 20 + random.below(12) + 0.5;
    const auto w = [&] { return std::exp2(random.below(4)); };
    const Float3 a = window.place(x0, y0, w()), b = window.place(x1, y0, w()), c = window.place(x1, y1, w()),
                 d = window.place(x0, y1, w());
    const Float2 at_a(0, 0), at_b(1, 0), at_c(1, 1), at_d(0, 1);
    const bool fold = random.below(2) == 0;
    Object& object = fold ? window.add({a, b, c, a, c, d}, Double3(1), {at_a, at_b, at_c, at_a, at_c, at_d})
                          : window.add({b, c, d, b, d, a}, Double3(1), {at_b, at_c, at_d, at_b, at_d, at_a});
    for (const Frame& frame : nearest_texels(window, object)) {
      for (int x = static_cast<int>(x0); x < static_cast<int>(x1); ++x)
        ++seen, wrong += frame.radiance.at(x, static_cast<int>(y0))[1] != 0;
      for (int y = static_cast<int>(y0); y < static_cast<int>(y1); ++y)
        ++seen, wrong += frame.radiance.at(static_cast<int>(x0), y)[0] != 0;
    }
  });
  // The coordinate 0 at the two corners right of the third: along their level edge it is 1 less two shares that add up
  // to 1 only but for their rounding.
  for_all(200, [&](Random& random) {
    WindowScene window(32);
    const double y = random.below(16) + 0.5, x1 = 5 + random.below(10) + 0.5, x2 = 20 + random.below(12) + 0.5;
    const auto w = [&] { return std::exp2(random.below(4)); };
    Object& object = window.add({window.place(x1 - random.below(4) - 1, y + 2 + random.below(13), w()),
                                 window.place(x1, y, w()), window.place(x2, y, w())},
                                Double3(1), {{0, 1}, {0, 0}, {0, 0}});
    for (const Frame& frame : nearest_texels(window, object)) {
      for (int x = static_cast<int>(x1); x < static_cast<int>(x2); ++x)
        ++seen, wrong += frame.radiance.at(x, static_cast<int>(y))[1] != 0;
    }
  });
  CHECK(seen > 1000);
  CHECK(wrong == 0);
}

TEST_CASE("I5: attributes are perspective-correct at the centre; an attribute is flat where its corners are equal") {
  // The row's other modes (noperspective, centroid, sample) are not offered. Worked by hand: from w = 1 at the left to
  // w = 3 at the right, half way across the window lies a quarter of the way along: 1/2 (1/3) / (1/2 (1) + 1/2 (1/3)).
  WindowScene window(16);
  window.add({window.place(0.5, 0, 1), window.place(16.5, 0, 3), window.place(0.5, 32, 1)}, Double3(1),
             {{0, 7}, {1, 7}, {0, 7}});
  const Frame frame = window.frame({Aov::uv});
  CHECK(frame.aovs[0].at(8, 0)[0] == 0.25f);
  CHECK(frame.aovs[0].at(8, 0)[1] == 7);
}

TEST_CASE("I6: a texture coordinate of 1e7 is taken as the float it is, and repeats are taken off exactly") {
  const auto texture = index_texture(8, 8);
  // Floats near 1e7 are whole numbers: every one is the border of the first texel.
  for (const float u : {1e7f, -1e7f, 9999999.f, 16777216.f, 0x1p40f, -0x1p40f})
    CHECK(look_up<double>(*texture, TextureFilter::nearest, static_cast<double>(u), 0).x == 0);
  // From 2^20 to 2^20 + 1 over a triangle: the same texels as from 0 to 1.
  const auto seen = [&](float base) {
    WindowScene window(32);
    Object& object = window.add({window.place(0, 0, 1), window.place(32, 0, 4), window.place(0, 32, 2)}, Double3(1),
                                {{base, base}, {base + 1, base}, {base, base + 1}});
    object.material.diffuse_map.texture = texture;
    object.material.diffuse_map.filter = TextureFilter::bilinear;
    return window.frame().radiance.values;
  };
  const std::vector<float> expected = seen(0);
  for (const float base : {1.f, -3.f, 0x1p20f, -0x1p22f}) CHECK(seen(base) == expected);
}

TEST_CASE_TEMPLATE("I7: at texel borders the texel is the floor of the exact coordinate, and -1e-9 is in the last one",
                   F, double, float) {
  for (const auto& size : {std::pair(1, 1), std::pair(3, 5), std::pair(4, 2), std::pair(7, 1), std::pair(640, 480)}) {
    const int width = size.first, height = size.second;
    CAPTURE(width);
    const auto texture = index_texture(width, height);
    std::vector<double> coordinates = {0,     -0.0, 1,      -1,       2,     0.5,    -0.5,
                                       -1e-9, 1e-9, -1e-30, 1 - 1e-9, 1e-40, -1e-40, 12345.678};
    for (int k = 0; k <= width; ++k)
      for (const double texel : {k - 0.5, static_cast<double>(k), k + 0.5})
        for (const F u : {static_cast<F>(texel / width), std::nextafter(static_cast<F>(texel / width), F(2)),
                          std::nextafter(static_cast<F>(texel / width), F(-2))})
          coordinates.push_back(static_cast<double>(u));
    for (const double coordinate : coordinates) {
      CAPTURE(coordinate);
      const F u = static_cast<F>(coordinate);
      // u n is one rounded product: the exact floor, but where it rounds onto the border above.
      const Rational scaled = Rational(u) * width;
      const F product = u * static_cast<F>(width);
      CHECK(abs(Rational(product) - scaled) <= abs(scaled) * Rational(std::numeric_limits<F>::epsilon()) / 2 +
                                                   Rational(std::numeric_limits<F>::denorm_min()));
      const auto nearest = look_up<F>(*texture, TextureFilter::nearest, coordinate, 0);
      const int expected = wrapped(exact_cell(Rational(product)).index, width);
      CHECK(nearest.x == static_cast<F>(expected));

      const F shifted = product - F(0.5);
      const ExactCell at = exact_cell(Rational(shifted));
      const Mpfr left(wrapped(at.index, width)), right(wrapped(at.index + 1, width));
      const Mpfr between = left + (right - left) * exact(at.fraction);
      const auto bilinear = look_up<F>(*texture, TextureFilter::bilinear, coordinate, 0);
      // Fraction, difference, product and sum: each rounds a number no larger than the width.
      CHECK(abs(Mpfr(bilinear.x) - between) <= Mpfr(4 * width) * Mpfr(std::numeric_limits<F>::epsilon()) / 2);
    }
    CHECK(look_up<F>(*texture, TextureFilter::nearest, -1e-9, 0).x == static_cast<F>(width - 1));
    CHECK(look_up<F>(*texture, TextureFilter::nearest, 0, -1e-9).y == static_cast<F>(height - 1));
    CHECK(look_up<F>(*texture, TextureFilter::nearest, 1, 1) == Rgb<F>(F(0)));
  }
}

TEST_CASE("I8: a texture coordinate that is NaN or infinite gives the colour at 0, and is counted") {
  const auto texture = index_texture(4, 4);
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), INFINITY, -INFINITY})
    for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear})
      for (const Precision precision : {Precision::double_, Precision::float_}) {
        WindowScene window(8);
        Object& object = window.add({window.place(-8, -8, 1), window.place(24, -8, 1), window.place(-8, 24, 1)},
                                    Double3(1), {{bad, 0.375f}, {bad, 0.375f}, {bad, 0.375f}});
        object.material.diffuse_map.texture = texture;
        object.material.diffuse_map.filter = filter;
        RenderOptions options = window.options();
        options.precision = precision;
        const Frame frame = render(window.scene, options);
        CHECK(frame.counts.undefined[Undefined::bad_uv] == 64);
        // v = 0.375 is the centre of row 1. u = 0: texel 0, or half way between the last and the first.
        for (int i = 0; i < 64; ++i) {
          CHECK(frame.radiance.at(i % 8, i / 8)[0] == (filter == TextureFilter::nearest ? 0 : 1.5f));
          CHECK(frame.radiance.at(i % 8, i / 8)[1] == 1);
        }
      }
}

TEST_CASE("I9: a triangle without texture coordinates is white, and nothing is counted") {
  const auto texture = index_texture(4, 4);
  for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear})
    for (const Precision precision : {Precision::double_, Precision::float_, Precision::fast})
      for (const std::size_t textured : {0u, 2u, 3u, 5u}) { // vertices; of the triangle on the left it needs three
        WindowScene window(16);
        Object& object = window.add({window.place(-8, -8, 1), window.place(-8, 40, 1), window.place(8, 8, 1),
                                     window.place(24, -8, 1), window.place(24, 40, 1), window.place(8, 8, 1)},
                                    Double3(1), std::vector<Float2>(textured, Float2(0.375f)));
        std::get<Phong>(object.material.fragment_function).kd = Double3(1); // no light: for the albedo
        object.material.diffuse_map.texture = texture;
        object.material.diffuse_map.filter = filter;
        RenderOptions options = window.options({Aov::triangle, Aov::uv, Aov::albedo});
        options.precision = precision;
        const Frame frame = render(window.scene, options);
        CHECK(frame.counts.undefined[Undefined::bad_uv] == 0);
        std::size_t shown = 0;
        for (int i = 0; i < 256; ++i) {
          const int x = i % 16, y = i / 16;
          const float triangle = frame.aovs[0].at(x, y)[0];
          if (triangle == 0) continue;
          ++shown;
          const bool has_uv = triangle == 1 && textured >= 3;
          const Float3 colour = has_uv ? Float3(1, 1, 0) : Float3(1); // in the middle of texel (1, 1)
          for (int c = 0; c < 3; ++c) {
            CHECK(frame.radiance.at(x, y)[c] == colour[c]);
            CHECK(frame.aovs[2].at(x, y)[c] == colour[c]);
          }
          for (int c = 0; c < 2; ++c) CHECK(frame.aovs[1].at(x, y)[c] == (has_uv ? 0.375f : 0.0f));
        }
        CHECK(shown > 100);
      }
}
