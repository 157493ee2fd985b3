#include "gl/probe/detail.h"

#include <refraster/texture.h>

#include "gl/draw/upload.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace refraster {
namespace {

constexpr int texels = 256, level_count = 9; // of the texture
constexpr int side = 512, cell = 16, cells = side / cell;
constexpr double lowest_detail = 0.5, detail_step = 5.0 / 32; // every 32nd of a level is among the multiples

/// Levels up to and including this one are black, and smaller ones white: a read shows how far beyond it is.
Texture split_after(int level) {
  Texture texture;
  for (int i = 0; i < level_count; ++i) {
    const int size = texels >> i;
    TextureLevel image{size, size, {}};
    image.rgb.resize(static_cast<std::size_t>(3 * size * size), i <= level ? 0.0f : 255.0f);
    texture.levels.push_back(image);
  }
  return texture;
}

/// Squares with constant derivatives: one side of the footprint is 2^detail texels, turned by an angle, and the other,
/// across, is so much of it.
std::vector<ProbeVertex> footprints(double across) {
  std::vector<ProbeVertex> vertices;
  for (int row = 0; row < cells; ++row)
    for (int column = 0; column < cells; ++column) {
      const double one_side = std::exp2(lowest_detail + column * detail_step) / texels,
                   angle = row * std::numbers::pi / 2 / cells, c = one_side * std::cos(angle),
                   s = one_side * std::sin(angle);
      const auto vertex = [&](int right, int up) {
        const auto clip = [](int place) { return static_cast<float>(place * cell) * 2 / side - 1; };
        const double x = cell * (right - 0.5), y = cell * (up - 0.5);
        return ProbeVertex{
            {clip(column + right), clip(row + up), 0, 1},
            {static_cast<float>(0.5 + c * x - s * across * y), static_cast<float>(0.5 + s * x + c * across * y), 0, 0}};
      };
      for (const auto& [right, up] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
        vertices.push_back(vertex(right, up));
    }
  return vertices;
}

} // namespace

DetailFacts probe_detail(ProbeCanvas& canvas) {
  canvas.set_target(GL_RGBA32F, side, side);
  const GLuint program = canvas.program("    result = texture(tex, v.xy);\n", "uniform sampler2D tex;\n");
  DetailFacts facts;
  for (const double across : {1.0, 0.25, 4.0}) {
    const double longer = std::max(std::log2(across), 0.0);
    const std::vector<ProbeVertex> vertices = footprints(across);
    std::vector<double> detail(canvas.pixels());
    for (int level = 0; level < level_count - 1; ++level) {
      upload_texture(canvas.gl(), {.texture = std::make_shared<const Texture>(split_after(level)),
                                   .filter = TextureFilter::trilinear});
      canvas.clear(0);
      canvas.draw(program, vertices);
      const std::vector<float> values = canvas.read_floats();
      for (std::size_t i = 0; i < detail.size(); ++i) detail[i] += static_cast<double>(values[4 * i]);
    }
    // Not the outermost pixels of a square, whose neighbours are in another one.
    for (std::size_t y = 0; y < side; ++y)
      for (std::size_t x = 0; x < side; ++x) {
        if (x % cell < 2 || x % cell >= cell - 2 || y % cell < 2 || y % cell >= cell - 2) continue;
        const double wrong =
            detail[y * side + x] - (lowest_detail + longer + static_cast<double>(x / cell) * detail_step);
        facts.below = std::max(facts.below, -wrong), facts.above = std::max(facts.above, wrong);
      }
  }
  check_probe(canvas, "levels of detail");
  return facts;
}

} // namespace refraster
