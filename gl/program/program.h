#pragma once
// GLSL text becomes a program.

#include "gl/context/gl_api.h"

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
  std::vector<std::string> warnings;         // what compiler and linker had to say, each once
  std::vector<std::string> moved_attributes; // names not ours, and without a location in the shader
};

/// Compiles and links. vPos, vNormal, vTexCoord and vColor are attributes 0, 1, 2, 3 where the shader does not say so;
/// other names that it leaves to the driver come after them, so that what they get is not the driver's choice. Throws
/// InputError: a fault for each line of the compiler's log, with file, line and, where it tells one, column.
GlProgram link_program(const GlApi& gl, const ShaderText& vertex, const ShaderText& fragment);

/// What the driver says of a program that it would not draw with; empty if it says nothing.
std::string validation_log(const GlApi& gl, GLuint program);

/// A line of a compiler's log, taken apart: "0:12(5): error: …" (Mesa), "0(12) : error …" (NVIDIA),
/// "ERROR: 0:12: …" (Apple, ANGLE, AMD). Without a place, all of it is the message.
struct LogLine {
  int line = 0, column = 0;
  std::string message;
};
LogLine parse_log_line(const std::string& line);

/// The lines of a log, without repetitions and without what says nothing. Mesa puts several messages in one line.
std::vector<LogLine> parse_log(const std::string& log);

} // namespace refraster
