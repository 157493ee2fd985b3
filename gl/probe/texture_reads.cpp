#include "gl/probe/texture_reads.h"

#include <refraster/texture.h>

#include "gl/draw/upload.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace refraster {
namespace {

constexpr int texels = 64, side = 512;

Texture random_texture() {
  std::mt19937 random(1);
  Texture texture;
  for (int size = texels; size >= 1; size /= 2) {
    TextureLevel level{size, size, {}};
    for (int i = 0; i < 3 * size * size; ++i) level.rgb.push_back(static_cast<float>(random() & 255));
    texture.levels.push_back(level);
  }
  return texture;
}

double texel(const TextureLevel& level, int column, int row) {
  const auto wrapped = [](int i, int count) { return (i % count + count) % count; };
  const int at = wrapped(row, level.height) * level.width + wrapped(column, level.width);
  return static_cast<double>(level.rgb[static_cast<std::size_t>(3 * at)]) / 255;
}

/// A filtered read of red, and how it changes by texel.
struct Filtered {
  double value, along;
};

Filtered filtered(const TextureLevel& level, double column, double row) {
  const double s = column - 0.5, t = row - 0.5, a = s - std::floor(s), b = t - std::floor(t);
  const int i = static_cast<int>(std::floor(s)), j = static_cast<int>(std::floor(t));
  const double low = std::lerp(texel(level, i, j), texel(level, i + 1, j), a),
               high = std::lerp(texel(level, i, j + 1), texel(level, i + 1, j + 1), a),
               left = std::lerp(texel(level, i, j), texel(level, i, j + 1), b),
               right = std::lerp(texel(level, i + 1, j), texel(level, i + 1, j + 1), b);
  return {std::lerp(low, high, b), std::abs(right - left) + std::abs(high - low)};
}

/// Reads red at a place in texels of level 0 for each pixel; `places` sets vec2 at, in GLSL.
std::vector<float> reads(ProbeCanvas& canvas, const Texture& texture, TextureFilter filter, const std::string& places,
                         const std::string& lod) {
  const std::shared_ptr<const Texture> unowned(std::shared_ptr<const Texture>(), &texture);
  upload_texture(canvas.gl(), {.texture = unowned, .filter = filter}); // which stays bound to unit 0, as samplers read
  return canvas.evaluated(side, side,
                          pixel_number(side) + places + "    result = textureLod(tex, at / " +
                              std::to_string(texture.levels[0].width) + ".0, " + lod + ");\n",
                          "uniform sampler2D tex;\n");
}

/// Where the pixel of this number reads, in texels: GLSL that sets `at`, and the same here.
struct Places {
  const char* glsl;
  double (*column)(std::uint32_t i);
  double (*row)(std::uint32_t i);
};
// All are exact in float, as are those as fractions of 64 texels.
constexpr Places on_steps = {"    uint c = i * 2654435761u;\n"
                             "    vec2 at = vec2(float(c >> 18u), float((c >> 2u) & 16383u)) / 256.0;\n",
                             [](std::uint32_t i) { return (i * 2654435761u >> 18) / 256.0; },
                             [](std::uint32_t i) { return (i * 2654435761u >> 2 & 16383u) / 256.0; }};
constexpr Places on_even_steps = { // which are steps of level 1 as well
    "    uint c = i * 2654435761u;\n"
    "    vec2 at = vec2(float(c >> 19u), float((c >> 3u) & 8191u)) / 128.0;\n",
    [](std::uint32_t i) { return (i * 2654435761u >> 19) / 128.0; },
    [](std::uint32_t i) { return (i * 2654435761u >> 3 & 8191u) / 128.0; }};
constexpr Places anywhere = {"    uint c = i * 2654435761u, d = i * 2246822519u;\n"
                             "    vec2 at = vec2(float(c >> 12u), float(d >> 12u)) / 16384.0;\n",
                             [](std::uint32_t i) { return (i * 2654435761u >> 12) / 16384.0; },
                             [](std::uint32_t i) { return (i * 2246822519u >> 12) / 16384.0; }};
/// 4096 places at each of 64 borders of texels, on both sides. Of a few texels the places are closer than of many,
/// since a place has 24 bits.
struct Borders {
  int texels;
  double step; // between places, in texels
  double place(std::uint32_t i) const {
    return (i >> 12) * static_cast<std::uint32_t>(texels / 64) + ((i & 4095u) - 2047.5) * step;
  }
  std::string glsl() const {
    return "    vec2 at = vec2(float((i >> 12u) * " + std::to_string(texels / 64) +
           "u) + (float(i & 4095u) - 2047.5) / " + std::to_string(1 / step) + ", 0.5);\n";
  }
};
constexpr Borders few = {64, 0x1p-16}, many = {1024, 0x1p-13};

/// Calls visit(i, value).
void for_each_read(const std::vector<float>& values, const auto& visit) {
  for (std::uint32_t i = 0; i < values.size() / 4; ++i) visit(i, static_cast<double>(values[4 * i]));
}

/// How far from a border the wrong texel is read.
double nearest_place(ProbeCanvas& canvas, const Borders& borders) {
  Texture stripes; // neighbours differ
  stripes.levels.push_back({borders.texels, 1, {}});
  for (int i = 0; i < borders.texels; ++i)
    for (int k = 0; k < 3; ++k) stripes.levels[0].rgb.push_back(i % 2 ? 255.0f : 0.0f);
  double most = 0;
  for_each_read(reads(canvas, stripes, TextureFilter::nearest, borders.glsl(), "0.0"),
                [&](std::uint32_t i, double value) {
                  const double place = borders.place(i), border = std::nearbyint(place);
                  const bool odd = (static_cast<int>(std::floor(place)) & 1) != 0;
                  if ((value > 0.5) != odd) most = std::max(most, std::abs(place - border));
                });
  return most;
}

/// How many values a ramp of one texel from 0 to full scale has.
int different_weights(ProbeCanvas& canvas) {
  Texture ramp;
  ramp.levels.push_back({2, 1, {0, 0, 0, 255, 255, 255}});
  const std::vector<float> values =
      reads(canvas, ramp, TextureFilter::bilinear, "    vec2 at = vec2(0.5 + float(i) / 262144.0, 0.5);\n", "0.0");
  std::set<float> different;
  for (std::size_t i = 0; i < values.size(); i += 4) different.insert(values[i]);
  return static_cast<int>(different.size());
}

} // namespace

TextureFacts probe_texture_reads(ProbeCanvas& canvas) {
  TextureFacts facts;
  const Texture texture = random_texture();
  const auto ideal = [&](const Places& places, std::uint32_t i) {
    return filtered(texture.levels[0], places.column(i), places.row(i));
  };
  for_each_read(reads(canvas, texture, TextureFilter::bilinear, on_steps.glsl, "0.0"),
                [&](std::uint32_t i, double value) {
                  facts.value = std::max(facts.value, std::abs(value - ideal(on_steps, i).value));
                });
  for_each_read(reads(canvas, texture, TextureFilter::bilinear, anywhere.glsl, "0.0"),
                [&](std::uint32_t i, double value) {
                  const Filtered right = ideal(anywhere, i);
                  const double error = std::abs(value - right.value) - facts.value;
                  facts.value_anywhere = std::max(facts.value_anywhere, std::abs(value - right.value));
                  if (right.along > 0.5) facts.weight_place = std::max(facts.weight_place, error / right.along);
                });
  for_each_read(reads(canvas, texture, TextureFilter::trilinear, on_even_steps.glsl, "0.5"), [&](std::uint32_t i,
                                                                                                 double value) {
    const double column = on_even_steps.column(i), row = on_even_steps.row(i);
    const double right =
        (filtered(texture.levels[0], column, row).value + filtered(texture.levels[1], column / 2, row / 2).value) / 2;
    facts.value_between_levels = std::max(facts.value_between_levels, std::abs(value - right));
  });
  facts.nearest_place = nearest_place(canvas, few), facts.nearest_resolution = few.step;
  // Where the bits of a place are those of the texture's whole width, more texels show more.
  if (const double of_many = nearest_place(canvas, many); of_many > facts.nearest_place)
    facts.nearest_place = of_many, facts.nearest_resolution = many.step;
  facts.weights = different_weights(canvas);
  check_probe(canvas, "texture reads");
  return facts;
}

} // namespace refraster
