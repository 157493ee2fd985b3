#pragma once
// What OpenGL reports of a call that it could not do.

#include "gl/context/gl_api.h"

#include <string>

namespace refraster {

/// The first error since the last call, or GL_NO_ERROR; all others are forgotten.
GLenum take_error(const GlApi& gl);

/// "GL_INVALID_OPERATION"; "error 1234" for what OpenGL does not define.
std::string error_name(GLenum error);

/// Throws NoOpenGl if there was an error: "OpenGL reports GL_OUT_OF_MEMORY while " + what it was doing.
void throw_if_error(const GlApi& gl, const std::string& doing);

} // namespace refraster
