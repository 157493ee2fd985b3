#pragma once
// What is drawn to.

#include "gl/context/gl_api.h"
#include "gl/render_gl.h"

namespace refraster {

/// A framebuffer with colour in one format and depth in DEPTH32F. With several samples a pixel both are multisample
/// textures, which a shader can read sample by sample; with one they are renderbuffers.
struct GlTarget {
  GLuint framebuffer = 0, colour = 0, depth = 0;
  GLenum colour_format = GL_NONE;
  int width = 0, height = 0, samples = 1;
};

/// Makes a target and the current framebuffer of it. Throws NoOpenGl if that is more than this OpenGL can, or if it has
/// no such number of samples a pixel.
GlTarget make_target(const GlApi& gl, GLenum colour_format, const GlOptions& options);

/// Of the current framebuffer, by the sample's number.
std::vector<GlSamplePosition> sample_positions(const GlApi& gl, const GlTarget& target);

} // namespace refraster
