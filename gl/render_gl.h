#pragma once
// The same scene through OpenGL 3.3 or later, without a window.

#include <refraster/image.h>
#include <refraster/render.h>
#include <refraster/scene.h>

#include "gl/gl_names.h"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace refraster {

/// There is no OpenGL here that can do what was asked. The message says what is missing and what to install.
class NoOpenGl : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// A number of samples a pixel that this OpenGL does not have.
class NoSuchSamples : public NoOpenGl {
public:
  NoSuchSamples(const std::string& what, int asked, int fewer) : NoOpenGl(what), asked_(asked), fewer_(fewer) {}
  int asked() const { return asked_; }
  /// The most that it has below: 1, if nothing else.
  int fewer() const { return fewer_; }

private:
  int asked_, fewer_;
};

struct GlOptions {
  int width = 1280, height = 720;
  int samples = 1; // a pixel: 1, 2, 4, 8 or 16, where the driver decides
  GlRenderer renderer = GlRenderer::system_default;
  MerlFilter merl_filter = MerlFilter::manual;
  int timed_frames = 0;
  Transfer transfer = Transfer::linear; // of rgb8: with the sRGB curve its levels are made of the radiance
  // What to read back.
  bool want_rgb8 = true;
  bool want_radiance = false;
  bool want_depth = false;
  bool want_ids = false;
};

/// The driver, in its own words.
struct GlDriver {
  std::string vendor, renderer, version, glsl_version;
};

/// Wall and process CPU time of each timed frame, in milliseconds, in the order drawn.
struct GlTimes {
  std::vector<double> wall_ms, cpu_ms;
};

/// Where a sample lies in its pixel, from the pixel's upper left corner, in pixels: in [0, 1).
struct GlSamplePosition {
  double x = 0.5, y = 0.5;
  bool operator==(const GlSamplePosition&) const = default;
};

/// Pixels with a channel that is NaN, and those without but with an infinite one; the first of either, row by row.
struct NonFinitePixels {
  std::uint64_t nan = 0, infinite = 0;
  int nan_x = 0, nan_y = 0, infinite_x = 0, infinite_y = 0;
};

/// All from draws of one scene by one program and the same state; see `warnings` for a driver that does not repeat
/// itself. With several samples a pixel colours are the driver's resolve of them, depth and ids those of sample 0.
struct GlFrame {
  Image<std::uint8_t> rgb8; // 3 channels, from an RGBA8 target; with the sRGB curve from `radiance`
  Image<float> radiance;    // 3 channels, from an RGBA32F target
  Image<float> depth;       // 1 channel, window depth in [0, 1] from a DEPTH32F target; 1 where nothing was drawn
  Image<float> ids;         // 2 channels: object and triangle in its mesh, each counted from 1; 0 where nothing
  std::vector<GlSamplePosition> sample_positions; // by number, in the driver's words (glGetMultisamplefv)
  GlDriver driver;
  GlTimes times;
  std::uint64_t samples_passed = 0;  // the depth test, in one frame
  std::vector<std::string> shaders;  // one line for each object: whose GLSL draws it, and why
  std::vector<std::string> warnings; // of compilers, of what shaders ask for in vain, and of what is wrong in the image
  NonFinitePixels non_finite;        // as in `radiance`, whether that is wanted or not
};

/// Draws the scene with the GLSL that it names where those files exist, else with our own GLSL of the same formulas.
/// docs/glsl-interface.md says what a shader is given. Drawn as an application draws, y up in the window, so that
/// gl_FragCoord, dFdy, gl_FrontFacing and ties on edges are OpenGL's own; but row 0 of each image is the top. Throws
/// NoOpenGl, also for a number of samples that this OpenGL does not have; InputError for GLSL that does not compile,
/// link or draw, and as check_drawn_by_gl(). Not to be called from two threads at once: a driver is chosen by the
/// environment of the process.
GlFrame render_gl(const Scene& scene, const GlOptions& options);

} // namespace refraster
