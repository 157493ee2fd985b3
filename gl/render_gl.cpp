#include "gl/render_gl.h"

#include "gl/context/context.h"
#include "gl/context/frame_timer.h"
#include "gl/context/gl_errors.h"
#include "gl/context/target.h"
#include "gl/draw/drawing.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace refraster {
namespace {

/// The current framebuffer's pixels, the top row first. OpenGL counts rows from the bottom, and gives them so.
template <class Value>
Image<Value> read_pixels(const GlApi& gl, const GlOptions& options, GLenum format, int channels) {
  Image<Value> image(options.width, options.height, channels);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, options.width, options.height, format, sizeof(Value) == 1 ? GL_UNSIGNED_BYTE : GL_FLOAT,
                image.values.data());
  const auto row_values = static_cast<std::ptrdiff_t>(options.width) * channels;
  for (int top = 0, bottom = options.height - 1; top < bottom; ++top, --bottom) {
    const auto row = image.values.begin() + top * row_values;
    std::swap_ranges(row, row + row_values, image.values.begin() + bottom * row_values);
  }
  return image;
}

NonFinitePixels non_finite_pixels(const Image<float>& image) {
  NonFinitePixels found;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const float* const pixel = image.at(x, y);
      if (std::any_of(pixel, pixel + image.channels, [](float value) { return std::isnan(value); })) {
        if (found.nan++ == 0) found.nan_x = x, found.nan_y = y;
      } else if (std::any_of(pixel, pixel + image.channels, [](float value) { return std::isinf(value); })) {
        if (found.infinite++ == 0) found.infinite_x = x, found.infinite_y = y;
      }
    }
  return found;
}

void warn_of(const NonFinitePixels& found, std::vector<std::string>& warnings) {
  const auto warn = [&](std::uint64_t count, const std::string& what, int x, int y, const std::string& effect) {
    if (count > 0)
      warnings.push_back((count == 1 ? "1 pixel is " : std::to_string(count) + " pixels are ") + what +
                         (count == 1 ? ", at " : ", the first at ") + std::to_string(x) + "," + std::to_string(y) +
                         " from the top left: " + effect);
  };
  warn(found.nan, "NaN", found.nan_x, found.nan_y, "what 8 bits show there is the driver's choice");
  warn(found.infinite, "infinite", found.infinite_x, found.infinite_y, "8 bits show the end of their range there");
}

} // namespace

GlFrame render_gl(const Scene& scene, const GlOptions& options) {
  const GlContext context(options.renderer);
  const GlApi& gl = context.gl();
  GlFrame frame;
  frame.driver = context.driver();

  make_target(gl, GL_RGBA8, options);
  GlDrawing drawing(gl, scene, options);
  frame.shaders = drawing.shaders();
  frame.samples_passed = drawing.draw_checked(); // and what drivers put off until the first frame is done
  frame.warnings = drawing.warnings();
  if (options.want_rgb8) frame.rgb8 = read_pixels<std::uint8_t>(gl, options, GL_RGB, 3);
  if (options.want_depth) frame.depth = read_pixels<float>(gl, options, GL_DEPTH_COMPONENT, 1);
  gl.Finish();
  frame.times = time_frames(options.timed_frames, [&] {
    drawing.draw(GlPass::colour);
    gl.Finish();
  });

  make_target(gl, GL_RGBA32F, options);
  drawing.draw(GlPass::colour);
  Image<float> radiance = read_pixels<float>(gl, options, GL_RGB, 3);
  frame.non_finite = non_finite_pixels(radiance);
  warn_of(frame.non_finite, frame.warnings);
  if (options.want_radiance) frame.radiance = std::move(radiance);
  if (options.want_ids) {
    drawing.draw(GlPass::ids);
    frame.ids = read_pixels<float>(gl, options, GL_RG, 2);
  }
  throw_if_error(gl, "drawing and reading back");
  return frame;
}

} // namespace refraster
