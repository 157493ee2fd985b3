#include "gl/context/gl_errors.h"

#include "gl/render_gl.h"

namespace refraster {

GLenum take_error(const GlApi& gl) {
  const GLenum first = gl.GetError();
  // One flag an error: GL 4.6 core, 2.3.1. A context that is lost reports its loss for ever.
  for (int flag = 0; first != GL_NO_ERROR && flag < 16 && gl.GetError() != GL_NO_ERROR; ++flag) continue;
  return first;
}

std::string error_name(GLenum error) {
  switch (error) {
  case GL_INVALID_ENUM:
    return "GL_INVALID_ENUM";
  case GL_INVALID_VALUE:
    return "GL_INVALID_VALUE";
  case GL_INVALID_OPERATION:
    return "GL_INVALID_OPERATION";
  case GL_INVALID_FRAMEBUFFER_OPERATION:
    return "GL_INVALID_FRAMEBUFFER_OPERATION";
  case GL_OUT_OF_MEMORY:
    return "GL_OUT_OF_MEMORY";
  default:
    return "error " + std::to_string(error);
  }
}

void throw_if_error(const GlApi& gl, const std::string& doing) {
  if (const GLenum error = take_error(gl); error != GL_NO_ERROR)
    throw NoOpenGl("OpenGL reports " + error_name(error) + " while " + doing);
}

} // namespace refraster
