#include "verify/gl/program.h"

#include "io/input_error.h"

#include <functional>
#include <regex>
#include <sstream>

namespace refraster {
namespace {

/// The log that `get` copies.
std::string log_of(GLint length, const std::function<void(GLsizei, GLchar*)>& get) {
  if (length <= 1) return {};
  std::string log(static_cast<std::size_t>(length), '\0');
  get(length, log.data());
  log.resize(log.find_last_not_of(std::string("\0\n ", 3)) + 1);
  return log;
}

std::vector<LogLine> lines_of(const std::string& log) {
  std::vector<LogLine> lines;
  std::istringstream stream(log);
  for (std::string line; std::getline(stream, line);)
    if (line.find_first_not_of(" \t\r") != std::string::npos) lines.push_back(parse_log_line(line));
  return lines;
}

/// Appends a compiler's warnings; the name of the shader is freed with the program.
GLuint compiled(const GlApi& gl, ShaderStage stage, const ShaderText& source, std::vector<std::string>& warnings) {
  const GLuint shader = gl.CreateShader(stage == ShaderStage::vertex ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
  const GLchar* const text = source.text.data();
  const auto size = static_cast<GLint>(source.text.size());
  gl.ShaderSource(shader, 1, &text, &size);
  gl.CompileShader(shader);

  GLint good = GL_FALSE, length = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &good);
  gl.GetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  const std::string log =
      log_of(length, [&](GLsizei room, GLchar* out) { gl.GetShaderInfoLog(shader, room, nullptr, out); });
  std::vector<InputFault> faults;
  for (const LogLine& line : lines_of(log)) {
    const InputFault fault{source.file, line.line, line.column, "", line.message, ""};
    if (good) warnings.push_back(fault.text());
    else faults.push_back(fault);
  }
  if (good) return shader;
  if (faults.empty()) faults.push_back({source.file, 0, 0, "", "an error that the compiler does not explain", "GLSL"});
  throw InputError(std::move(faults));
}

} // namespace

LogLine parse_log_line(const std::string& line) {
  static const std::regex forms[] = {
      std::regex(R"(^\s*\d+:(\d+)\((\d+)\)\s*:\s*(?:error:|warning:)?\s*(.*)$)"), // 0:12(5): error: …
      std::regex(R"(^\s*\d+\((\d+)\)()\s*:\s*(.*)$)"),                            // 0(12) : error …
      std::regex(R"(^\s*(?:ERROR|WARNING):\s*\d+:(\d+)()\s*:\s*(.*)$)"),          // ERROR: 0:12: …
  };
  const auto number = [](const std::ssub_match& digits) {
    return digits.length() > 0 && digits.length() < 9 ? std::stoi(digits) : 0;
  };
  for (const std::regex& form : forms)
    if (std::smatch found; std::regex_match(line, found, form)) return {number(found[1]), number(found[2]), found[3]};
  return {0, 0, line};
}

GlProgram link_program(const GlApi& gl, const ShaderText& vertex, const ShaderText& fragment) {
  GlProgram program;
  const GLuint stages[] = {compiled(gl, ShaderStage::vertex, vertex, program.warnings),
                           compiled(gl, ShaderStage::fragment, fragment, program.warnings)};
  program.name = gl.CreateProgram();
  for (const GLuint stage : stages) gl.AttachShader(program.name, stage);
  gl.BindAttribLocation(program.name, 0, "vPos");
  gl.BindAttribLocation(program.name, 1, "vNormal");
  gl.BindAttribLocation(program.name, 2, "vTexCoord");
  gl.LinkProgram(program.name);

  GLint good = GL_FALSE, length = 0;
  gl.GetProgramiv(program.name, GL_LINK_STATUS, &good);
  gl.GetProgramiv(program.name, GL_INFO_LOG_LENGTH, &length);
  const std::string log =
      log_of(length, [&](GLsizei room, GLchar* out) { gl.GetProgramInfoLog(program.name, room, nullptr, out); });
  std::vector<InputFault> faults;
  for (const LogLine& line : lines_of(log)) {
    const InputFault fault{vertex.file + " + " + fragment.file, line.line, line.column, "", line.message, ""};
    if (good) program.warnings.push_back(fault.text());
    else faults.push_back(fault);
  }
  if (good) return program;
  if (faults.empty())
    faults.push_back({vertex.file + " + " + fragment.file, 0, 0, "", "shaders that do not link", "a program"});
  throw InputError(std::move(faults));
}

} // namespace refraster
