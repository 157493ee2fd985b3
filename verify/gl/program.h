#pragma once
// GLSL text becomes a program.

#include "verify/gl/gl_api.h"

#include <string>
#include <vector>

namespace refraster {

enum class ShaderStage { vertex, fragment };

/// GLSL and where it comes from: a path, or a name for text of our own.
struct ShaderText {
  std::string file, text;
  bool operator==(const ShaderText&) const = default;
};

struct GlProgram {
  GLuint name = 0;
  std::vector<std::string> warnings; // what the compiler had to say
};

/// Compiles and links. Attributes vPos, vNormal and vTexCoord are 0, 1, 2 where the shader does not say so itself.
/// Throws InputError: a fault for each line of the compiler's log, with file, line and, where it tells one, column.
GlProgram link_program(const GlApi& gl, const ShaderText& vertex, const ShaderText& fragment);

/// A line of a compiler's log, taken apart: "0:12(5): error: …" (Mesa), "0(12) : error …" (NVIDIA),
/// "ERROR: 0:12: …" (Apple, ANGLE, AMD). Without a place, all of it is the message.
struct LogLine {
  int line = 0, column = 0;
  std::string message;
};
LogLine parse_log_line(const std::string& line);

} // namespace refraster
