#pragma once
// The types of GLSL that a program's variables may have.

#include "gl/context/gl_api.h"

#include <string>

namespace refraster {

/// What the components of a variable are; for samplers and images, of what they read.
enum class GlslBase { float_, int_, uint_, bool_, double_, depth };

enum class GlslKind { number, sampler, image, atomic_counter, unknown };

struct GlslType {
  GLenum type = GL_NONE;
  std::string name; // as GLSL writes it
  GlslKind kind = GlslKind::unknown;
  GlslBase base = GlslBase::float_;
  int columns = 1;         // of a matrix
  int components = 1;      // of a number; of a column where it is a matrix
  GLenum target = GL_NONE; // of a sampler: what is bound to its unit
};

/// Of OpenGL 4.6 core, table 7.3. Any other is of kind `unknown`, its name "type 0x1234".
const GlslType& glsl_type(GLenum type);

/// "vec4 palette[8]"; `size` 1 is no array. Of an array OpenGL tells the name of its first element, "palette[0]".
std::string declaration(const std::string& name, GLenum type, GLint size);

/// "vec4[8]", or "vec4".
std::string array_type_name(const std::string& name, GLenum type, GLint size);

/// "palette" of "palette[0]"; any other name as it is.
std::string array_name(const std::string& name);

} // namespace refraster
