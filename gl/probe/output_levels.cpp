#include "gl/probe/output_levels.h"

#include "raster/resolve/rgb8.h"

#include <algorithm>
#include <cmath>

namespace refraster {
namespace {

constexpr int side = 256; // pixel i has i / 65280: 256 steps a level

/// Calls visit(i, value, level).
void for_each_level(ProbeCanvas& canvas, GLenum format, const auto& visit) {
  canvas.set_target(format, side, side);
  canvas.clear(0);
  canvas.draw_all(canvas.program(pixel_number(side) + "    result = vec4(float(i) / 65280.0);\n"));
  const std::vector<std::uint8_t> levels = canvas.read_bytes();
  // The device's own quotient, which may be off by a few 2^-24: read back as float, so that it is known.
  canvas.set_target(GL_RGBA32F, side, side);
  canvas.draw_all(canvas.program(pixel_number(side) + "    result = vec4(float(i) / 65280.0);\n"));
  const std::vector<float> values = canvas.read_floats();
  for (std::size_t i = 0; i < side * side; ++i)
    visit(i, std::min(static_cast<double>(values[4 * i]), 1.0), static_cast<double>(levels[4 * i]));
}

} // namespace

OutputFacts probe_output(ProbeCanvas& canvas) {
  OutputFacts facts;
  facts.whole_levels_are_exact = true;
  for_each_level(canvas, GL_RGBA8, [&](std::size_t i, double value, double level) {
    facts.unorm = std::max(facts.unorm, std::abs(255 * value - level));
    if (i % 256 == 0 && i <= 65280) facts.whole_levels_are_exact &= level == static_cast<double>(i / 256);
  });
  canvas.gl().Enable(GL_FRAMEBUFFER_SRGB);
  for_each_level(canvas, GL_SRGB8_ALPHA8, [&](std::size_t, double value, double level) {
    facts.srgb = std::max(facts.srgb, std::abs(255 * srgb_encoded(value) - level));
  });
  canvas.gl().Disable(GL_FRAMEBUFFER_SRGB);
  check_probe(canvas, "rounding to 8 bits");
  return facts;
}

} // namespace refraster
