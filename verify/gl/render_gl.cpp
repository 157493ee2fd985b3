#include "verify/gl/render_gl.h"

#include "verify/gl/context.h"
#include "verify/gl/drawing.h"
#include "verify/gl/frame_timer.h"
#include "verify/gl/target.h"

#include <algorithm>

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

std::uint64_t counted_samples(const GlApi& gl, const GlDrawing& drawing) {
  GLuint query = 0, passed = 0;
  gl.GenQueries(1, &query);
  gl.BeginQuery(GL_SAMPLES_PASSED, query);
  drawing.draw(GlPass::colour);
  gl.EndQuery(GL_SAMPLES_PASSED);
  gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &passed);
  return passed;
}

} // namespace

GlFrame render_gl(const Scene& scene, const GlOptions& options) {
  const GlContext context(options.renderer);
  const GlApi& gl = context.gl();
  GlFrame frame;
  frame.driver = context.driver();

  make_target(gl, GL_RGBA8, options);
  const GlDrawing drawing(gl, scene, options);
  frame.shaders = drawing.shaders();
  frame.warnings = drawing.warnings();
  frame.samples_passed = counted_samples(gl, drawing); // and what drivers put off until the first frame is done
  if (options.want_levels) frame.levels = read_pixels<std::uint8_t>(gl, options, GL_RGB, 3);
  if (options.want_depth) frame.depth = read_pixels<float>(gl, options, GL_DEPTH_COMPONENT, 1);
  gl.Finish();
  frame.times = time_frames(options.timed_frames, [&] {
    drawing.draw(GlPass::colour);
    gl.Finish();
  });

  if (options.want_radiance || options.want_ids) make_target(gl, GL_RGBA32F, options);
  if (options.want_radiance) {
    drawing.draw(GlPass::colour);
    frame.radiance = read_pixels<float>(gl, options, GL_RGB, 3);
  }
  if (options.want_ids) {
    drawing.draw(GlPass::ids);
    frame.ids = read_pixels<float>(gl, options, GL_RG, 2);
  }
  if (const GLenum error = gl.GetError(); error != GL_NO_ERROR)
    throw std::runtime_error("OpenGL reports error " + std::to_string(error));
  return frame;
}

} // namespace refraster
