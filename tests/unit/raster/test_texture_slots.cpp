// Textures beside t: what they multiply, where they are read, and how colours get from an image to a picture.

#include <refraster/mesh.h>
#include <refraster/render.h>
#include <refraster/scene.h>

#include "tests/support/precisions.h"
#include "tests/support/scenes/poster.h"

#include <doctest/doctest.h>

#include <cmath>

namespace refraster::test {
namespace {

constexpr int side = 16;
/// Black, but for what a test adds.
Scene poster(float repeats = 1) {
  Phong black;
  black.ka = black.kd = black.ks = Double3(0);
  return poster_scene(black, repeats);
}

Phong& phong(Scene& scene) {
  return std::get<Phong>(scene.objects[0].material.fragment_function);
}

/// As many texels a side; red tells the column, green the row from below.
Texture numbered(int size) {
  Texture texture;
  TextureLevel level{size, size, {}};
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      for (const int value : {x, y, 128}) level.rgb.push_back(static_cast<float>(value));
  texture.levels.push_back(std::move(level));
  return texture;
}

TextureMap nearest(Texture texture) {
  return {.texture = std::make_shared<const Texture>(std::move(texture)), .filter = TextureFilter::nearest};
}

Frame drawn(const Scene& scene, Precision precision, Transfer transfer = Transfer::linear) {
  RenderOptions options;
  options.width = options.height = side;
  options.precision = precision;
  options.transfer = transfer;
  options.want_radiance = true;
  return render(scene, options);
}

} // namespace

TEST_CASE("light of its own is emissive times its map, with no light and once with many") {
  Scene scene = poster();
  scene.objects[0].material.emissive = {1, 0.5, 2};
  scene.objects[0].material.emissive_map = nearest(numbered(side));
  for (const int lights : {0, 3}) {
    scene.direction_lights.assign(static_cast<std::size_t>(lights), {{0, 0, -1}, Double3(1)}); // reflected by nothing
    for (const Precision precision : every_precision) {
      const Frame frame = drawn(scene, precision);
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
          // A whole number over 255, which is not a binary fraction, is rounded once, and once to float; fast divides
          // by multiplying, which is one rounding more.
          const auto is_near = [&](int c, double expected) {
            return std::abs(static_cast<double>(frame.radiance.at(x, y)[c]) - expected) <= 3 * 0x1p-24 * expected;
          };
          CHECK(is_near(0, x / 255.0));
          CHECK(is_near(1, 0.5 * (side - 1 - y) / 255.0));
          CHECK(is_near(2, 2 * 128 / 255.0));
        }
    }
  }
}

TEST_CASE("without a map it is emissive alone, and without both nothing is added") {
  Scene scene = poster();
  phong(scene).ka = {0.25, 0.5, 0.75};
  const Frame plain = drawn(scene, Precision::double_);
  scene.objects[0].material.emissive_map = nearest(numbered(side)); // of emissive 0
  CHECK(drawn(scene, Precision::double_).radiance.values == plain.radiance.values);
  scene.objects[0].material.emissive_map = {};
  scene.objects[0].material.emissive = {0.5, 0, 0.125};
  const Frame bright = drawn(scene, Precision::double_);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      CHECK(bright.radiance.at(x, y)[0] == 0.75f);
      CHECK(bright.radiance.at(x, y)[1] == 0.5f);
      CHECK(bright.radiance.at(x, y)[2] == 0.875f);
    }
}

TEST_CASE("a specular map multiplies ks, and nothing else") {
  Scene scene = poster();
  scene.direction_lights = {{{0.1, 0.2, -1}, {1, 2, 3}}};
  phong(scene).kd = Double3(0.5), phong(scene).glossiness = 3;
  Texture halves; // of one texel: each channel a power of two
  halves.full_scale = 1;
  halves.levels.push_back({1, 1, {0.5f, 0.25f, 1.0f}});
  for (const Precision precision : {Precision::double_, Precision::float_, Precision::exact}) {
    phong(scene).ks = {0.5, 0.25, 1};
    scene.objects[0].material.specular_map = {};
    const Frame by_parameter = drawn(scene, precision);
    phong(scene).ks = Double3(1);
    scene.objects[0].material.specular_map = nearest(halves);
    CHECK(drawn(scene, precision).radiance.values == by_parameter.radiance.values);
    scene.objects[0].material.specular_map = {};
    CHECK(drawn(scene, precision).radiance.values != by_parameter.radiance.values);
  }
}

TEST_CASE("maps of roughness and metalness multiply these, and nothing else") {
  Scene scene = poster();
  scene.direction_lights = {{{0.1, 0.2, -1}, {1, 2, 3}}};
  const auto one_texel = [](float value) {
    Texture texture;
    texture.full_scale = 1;
    texture.levels.push_back({1, 1, {value, value, value}});
    return nearest(texture);
  };
  Material& material = scene.objects[0].material;
  Microfacet function;
  function.base_color = {0.5, 0.25, 1};
  for (const Precision precision : {Precision::double_, Precision::float_, Precision::exact}) {
    function.roughness = 0.5, function.metallic = 0.25;
    material.fragment_function = function, material.roughness_map = material.metallic_map = {};
    const Frame by_parameters = drawn(scene, precision);
    function.roughness = function.metallic = 1;
    material.fragment_function = function;
    material.roughness_map = one_texel(0.5f), material.metallic_map = one_texel(0.25f);
    CHECK(drawn(scene, precision).radiance.values == by_parameters.radiance.values);
    material.metallic_map = {};
    CHECK(drawn(scene, precision).radiance.values != by_parameters.radiance.values);
    material.specular_map = one_texel(0.5f); // is none of this function's
    const Frame other = drawn(scene, precision);
    material.specular_map = {};
    CHECK(drawn(scene, precision).radiance.values == other.radiance.values);
  }
}

TEST_CASE("a clamped texture does not repeat, however far it is from the origin") {
  Scene scene = poster(2);
  TextureMap map = nearest(numbered(8));
  phong(scene).ka = Double3(1);
  const auto red = [&](int x) {
    scene.objects[0].material.diffuse_map = map;
    return std::lround(255 * static_cast<double>(drawn(scene, Precision::double_).radiance.at(x, side - 1)[0]));
  };
  CHECK(red(7) == 7);
  CHECK(red(8) == 0); // u = 1.06 begins anew
  map.wrap = TextureWrap::clamp;
  CHECK(red(7) == 7);
  CHECK(red(8) == 7);
  CHECK(red(15) == 7);
  map.offset = {-1, 0};
  CHECK(red(7) == 0);
  CHECK(red(8) == 0);
  CHECK(red(15) == 7);
  map = nearest(numbered(8));
  map.scale = {0.5, 1}; // u from 0 to 1
  CHECK(red(1) == 0);
  CHECK(red(2) == 1);
  CHECK(red(15) == 7);
  // Two whole repeats away, where halves of them count.
  Mesh mesh = *scene.objects[0].mesh;
  for (Float2& uv : mesh.uvs) uv.x += 3;
  scene.objects[0].mesh = std::make_shared<const Mesh>(std::move(mesh));
  CHECK(red(0) == 4); // u = (3 + 1/16) / 2
  map.wrap = TextureWrap::clamp;
  CHECK(red(0) == 7);
}

TEST_CASE("a picture with sRGB textures and sRGB output has the bytes of the texture where the light is 1") {
  // Every byte: 256 texels under ambient light of 1. Decoded in double and rounded to float, u = 2^-24, a value y is
  // off by y u at most, and `float` and `fast` make a few more roundings of it: encoded, by the curve's slope times
  // that, which is y's at most 12.92 times, where y <= 0.0031308, and less than 1 beyond 0.05. 255 times either is far
  // below the 0.5 that would make another byte of it. `fast` has an error of its own for the power: docs/precision.md.
  Texture all;
  TextureLevel level{16, 16, {}};
  for (int i = 0; i < 256; ++i)
    for (const int value : {i, 255 - i, (7 * i) % 256}) level.rgb.push_back(static_cast<float>(value));
  all.levels.push_back(level);
  decode_srgb(all);
  CHECK(all.full_scale == 1);
  Scene scene = poster();
  phong(scene).ka = Double3(1);
  scene.objects[0].material.diffuse_map = nearest(all);
  for (const Precision precision : every_precision) {
    const Frame frame = drawn(scene, precision, Transfer::srgb);
    for (int i = 0; i < 256; ++i)
      for (int c = 0; c < 3; ++c)
        CHECK(static_cast<float>(frame.rgb8.at(i % 16, 15 - i / 16)[c]) ==
              level.rgb[static_cast<std::size_t>(3 * i + c)]);
  }
}

TEST_CASE("sRGB is decoded before anything is made of it: between black and white there is half of the light") {
  Texture stripes;
  stripes.levels.push_back({2, 1, {0, 0, 0, 255, 255, 255}});
  decode_srgb(stripes);
  build_mip_levels(stripes);
  CHECK(stripes.levels.at(1).rgb.at(0) == 0.5f);
  CHECK_THROWS_AS(decode_srgb(stripes), std::invalid_argument);
}

} // namespace refraster::test
