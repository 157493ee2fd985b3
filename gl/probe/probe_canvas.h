#pragma once
// Small draws off screen, whose every position and pixel is known exactly.

#include "gl/context/gl_api.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace refraster {

struct ProbeVertex {
  std::array<float, 4> position; ///< in clip space
  std::array<float, 4> data{};   ///< what the fragment shader has as `v`
};

/// A colour target with depth, and draws to it. Rows count from the bottom, as in OpenGL. For the current context.
class ProbeCanvas {
public:
  /// Nothing is dithered, blended, culled or tested from now on.
  explicit ProbeCanvas(const GlApi& gl);

  const GlApi& gl() const { return gl_; }
  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t pixels() const { return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_); }

  /// A new target; the viewport is all of it. Throws NoOpenGl.
  void set_target(GLenum colour_format, int width, int height);

  /// A program of the vertex stage that hands on position and `v`, and of this body of main() in a fragment shader that
  /// sets `vec4 result`. `declarations` stand before main(). Throws InputError where the driver refuses it.
  GLuint program(const std::string& body, const std::string& declarations = {}) const;

  /// All channels to this value, depth to 1.
  void clear(float value) const;
  /// Three vertices a triangle.
  void draw(GLuint program, const std::vector<ProbeVertex>& vertices);
  /// Two triangles that cover the target; v is the window's place from 0 to 1 in x and y.
  void draw_all(GLuint program);

  /// Four values a pixel.
  std::vector<float> read_floats() const;
  std::vector<std::uint8_t> read_bytes() const;
  /// One a pixel.
  std::vector<float> read_depth() const;

  /// What `body` makes of every pixel, in red, green, blue and alpha, of a float target of this size.
  std::vector<float> evaluated(int width, int height, const std::string& body, const std::string& declarations = {});

private:
  const GlApi& gl_;
  GLuint buffers_[2] = {}; // vertices, indices
  int width_ = 0, height_ = 0;
};

/// GLSL: `uint i` is the number of the pixel, row by row in a target of this width.
std::string pixel_number(int width);

/// Throws NoOpenGl for what went wrong since the last call.
void check_probe(const ProbeCanvas& canvas, const std::string& probe);

} // namespace refraster
