#include "gl/render_gl.h"

#include "gl/context/context.h"
#include "gl/context/frame_timer.h"
#include "gl/context/gl_errors.h"
#include "gl/context/target.h"
#include "gl/draw/drawing.h"
#include "gl/draw/read_back.h"
#include "shading/srgb_curve.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace refraster {
namespace {

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

/// "1 pixel is …, at 3,4 from the top left"; "7 pixels are …, the first at 3,4 from the top left".
std::string pixels_are(std::uint64_t count, const std::string& what, int x, int y) {
  return (count == 1 ? "1 pixel is " : std::to_string(count) + " pixels are ") + what +
         (count == 1 ? ", at " : ", the first at ") + std::to_string(x) + "," + std::to_string(y) +
         " from the top left";
}

void warn_of(const NonFinitePixels& found, std::vector<std::string>& warnings) {
  if (found.nan > 0)
    warnings.push_back(pixels_are(found.nan, "NaN", found.nan_x, found.nan_y) +
                       ": what 8 bits show there is the driver's choice");
  if (found.infinite > 0)
    warnings.push_back(pixels_are(found.infinite, "infinite", found.infinite_x, found.infinite_y) +
                       ": 8 bits show the end of their range there");
}

/// The same program and state give the same depth, bit for bit (OpenGL 4.6, A.2, rule 2): else the images are not of
/// the same surfaces.
void warn_of_other_depth(const Image<float>& depth, const Image<float>& other, const std::string& whose,
                         const std::string& meaning, std::vector<std::string>& warnings) {
  std::uint64_t count = 0;
  int first_x = 0, first_y = 0;
  for (int y = 0; y < depth.height; ++y)
    for (int x = 0; x < depth.width; ++x)
      if (std::bit_cast<std::uint32_t>(*depth.at(x, y)) != std::bit_cast<std::uint32_t>(*other.at(x, y)) &&
          count++ == 0)
        first_x = x, first_y = y;
  if (count > 0)
    warnings.push_back(pixels_are(count,
                                  "of another depth in the draw of " + whose + " than in that of the float image",
                                  first_x, first_y) +
                       ": " + meaning);
}

/// Levels of the sRGB curve, as an application makes them that reads floats back. NaN becomes 0.
Image<std::uint8_t> srgb_levels(const Image<float>& radiance) {
  Image<std::uint8_t> levels(radiance.width, radiance.height, radiance.channels);
  std::transform(radiance.values.begin(), radiance.values.end(), levels.values.begin(), [](float value) {
    const double in_range = value > 0 ? std::min(static_cast<double>(value), 1.0) : 0;
    return static_cast<std::uint8_t>(std::nearbyint(255 * srgb_encoded(in_range)));
  });
  return levels;
}

} // namespace

GlFrame render_gl(const Scene& scene, const GlOptions& options) {
  const GlContext context(options.renderer);
  const GlApi& gl = context.gl();
  GlFrame frame;
  frame.driver = context.driver();

  const bool want_surfaces = options.want_depth || options.want_ids;
  const GlTarget levels = make_target(gl, GL_RGBA8, options);
  GlDrawing drawing(gl, scene, options);
  frame.shaders = drawing.shaders();
  frame.samples_passed = drawing.draw_checked(); // and what drivers put off until the first frame is done
  frame.warnings = drawing.warnings();
  if (options.want_rgb8) frame.rgb8 = read_rgb8(gl, levels);
  Image<float> levels_depth;
  if (options.want_rgb8 && want_surfaces) levels_depth = read_sample_depth(gl, levels, 0);
  gl.Finish();
  frame.times = time_frames(options.timed_frames, [&] {
    drawing.draw(GlPass::colour);
    gl.Finish();
  });

  const GlTarget floats = make_target(gl, GL_RGBA32F, options);
  frame.sample_positions = sample_positions(gl, floats);
  drawing.draw(GlPass::colour);
  Image<float> radiance = read_radiance(gl, floats);
  frame.non_finite = non_finite_pixels(radiance);
  warn_of(frame.non_finite, frame.warnings);
  if (options.want_rgb8 && options.transfer == Transfer::srgb) frame.rgb8 = srgb_levels(radiance);
  if (options.want_radiance) frame.radiance = std::move(radiance);
  if (want_surfaces) {
    Image<float> depth = read_sample_depth(gl, floats, 0);
    if (options.want_rgb8)
      warn_of_other_depth(depth, levels_depth, "the 8-bit image", "the driver does not repeat itself", frame.warnings);
    if (options.want_ids) {
      drawing.draw(GlPass::ids);
      frame.ids = read_sample(gl, floats, 0, 2);
      warn_of_other_depth(depth, read_sample_depth(gl, floats, 0), "the ids",
                          "its fragment shader discards there or sets the depth, which the ids do not know",
                          frame.warnings);
    }
    if (options.want_depth) frame.depth = std::move(depth);
  }
  throw_if_error(gl, "drawing and reading back");
  return frame;
}

} // namespace refraster
