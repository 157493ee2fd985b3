#pragma once
// What is drawn to.

#include "gl/context/gl_api.h"
#include "gl/render_gl.h"

namespace refraster {

/// Makes colour in the given format and depth in DEPTH32F the current framebuffer. Throws NoOpenGl if that is more than
/// this OpenGL can.
void make_target(const GlApi& gl, GLenum colour_format, const GlOptions& options);

} // namespace refraster
