#include "gl/program/program.h"

#include <refraster/mesh.h>
#include <refraster/notes.h>

#include "gl/program/glsl_types.h"
#include "gl/program/introspection.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <regex>
#include <sstream>
#include <tuple>

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

/// "phong_fs.glsl:12:5: the compiler warns: …"
std::string warning_text(const std::string& file, const LogLine& line, const std::string& who) {
  std::string text = file;
  if (line.line > 0) text += ":" + std::to_string(line.line);
  if (line.column > 0) text += ":" + std::to_string(line.column);
  return text + ": " + who + " warns: " + line.message;
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
  for (const LogLine& line : parse_log(log))
    if (good) warnings.push_back(warning_text(source.file, line, "the compiler"));
    else faults.push_back({source.file, line.line, line.column, "", line.message, ""});
  if (good) return shader;
  if (faults.empty()) faults.push_back({source.file, 0, 0, "", "an error that the compiler does not explain", "GLSL"});
  throw InputError(std::move(faults));
}

/// By location.
constexpr std::array own_attributes =
    std::apply([](const auto&... attribute) { return std::array{attribute.input...}; }, vertex_attributes);

bool linked(const GlApi& gl, GLuint program) {
  gl.LinkProgram(program);
  GLint good = GL_FALSE;
  gl.GetProgramiv(program, GL_LINK_STATUS, &good);
  return good == GL_TRUE;
}

/// Attributes that are not ours are bound behind those that are, and the program is linked again. Where the shader
/// itself gives a location that is the one that counts: GLSL 4.60, 4.4.1. Whether the program is linked afterwards.
bool move_attributes(const GlApi& gl, GlProgram& program) {
  constexpr auto own_count = static_cast<GLint>(std::size(own_attributes));
  const std::vector<ProgramVariable> before = active_attributes(gl, program.name);
  const auto end_of = [](const ProgramVariable& a) { return a.location + a.size * glsl_type(a.type).columns; };
  GLint end = own_count, most = 0;
  for (const ProgramVariable& attribute : before) end = std::max(end, end_of(attribute));
  gl.GetIntegerv(GL_MAX_VERTEX_ATTRIBS, &most);
  std::vector<ProgramVariable> foreign;
  for (const ProgramVariable& attribute : before)
    if (attribute.location < own_count &&
        std::count(std::begin(own_attributes), std::end(own_attributes), attribute.name) == 0) {
      const GLint place = end;
      end += end_of(attribute) - attribute.location;
      if (end > most) break; // no room: it stays where the driver put it
      gl.BindAttribLocation(program.name, static_cast<GLuint>(place), attribute.name.c_str());
      foreign.push_back(attribute);
    }
  if (foreign.empty()) return true;
  if (!linked(gl, program.name)) return false;
  for (const ProgramVariable& attribute : foreign)
    if (gl.GetAttribLocation(program.name, attribute.name.c_str()) != attribute.location)
      program.moved_attributes.push_back(attribute.name);
  return true;
}

} // namespace

LogLine parse_log_line(const std::string& line) {
  static const std::regex forms[] = {
      std::regex(R"(^\s*\d+:(\d+)\((\d+)\)\s*:\s*(?:error:|warning:)?\s*(.*)$)"), // 0:12(5): error: …
      std::regex(R"(^\s*\d+\((\d+)\)()\s*:\s*(.*)$)"),                            // 0(12) : error …
      std::regex(R"(^\s*(?:ERROR|WARNING):\s*\d+:(\d+)()\s*:\s*(.*)$)"),          // ERROR: 0:12: …
      std::regex(R"(^\s*()()(?:error|warning):\s*(.*)$)"),                        // error: …
  };
  const auto number = [](const std::ssub_match& digits) {
    return digits.length() > 0 && digits.length() < 9 ? std::stoi(digits) : 0;
  };
  for (const std::regex& form : forms)
    if (std::smatch found; std::regex_match(line, found, form)) return {number(found[1]), number(found[2]), found[3]};
  return {0, 0, line};
}

std::vector<LogLine> parse_log(const std::string& log) {
  // Where a message begins behind another one, perhaps ended by a full stop.
  static const std::regex next(R"((\S?)\.?((?:error|warning): ))");
  std::string lines;
  std::size_t end = 0;
  for (std::sregex_iterator found(log.begin(), log.end(), next); found != std::sregex_iterator(); ++found) {
    const std::smatch& match = *found;
    const bool in_line = match[1].length() > 0;
    lines += log.substr(end, static_cast<std::size_t>(match.position()) - end) + match[1].str() +
             (in_line ? "\n" : "") + match[2].str();
    end = static_cast<std::size_t>(match.position() + match.length());
  }
  lines += log.substr(end);

  std::vector<LogLine> parsed;
  std::istringstream stream(lines);
  for (std::string text; std::getline(stream, text);) {
    const LogLine line = parse_log_line(text);
    if (line.message.find_first_not_of(". \t\r") == std::string::npos) continue;
    const bool repeated = std::any_of(parsed.begin(), parsed.end(), [&](const LogLine& other) {
      return line.line == other.line && line.column == other.column && line.message == other.message;
    });
    if (!repeated) parsed.push_back(line);
  }
  return parsed;
}

std::string validation_log(const GlApi& gl, GLuint program) {
  gl.ValidateProgram(program);
  GLint length = 0;
  gl.GetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  const std::string log =
      log_of(length, [&](GLsizei room, GLchar* out) { gl.GetProgramInfoLog(program, room, nullptr, out); });
  std::string words;
  for (const LogLine& line : parse_log(log)) words += (words.empty() ? "" : "; ") + line.message;
  return words;
}

GlProgram link_program(const GlApi& gl, const ShaderText& vertex, const ShaderText& fragment) {
  GlProgram program;
  const GLuint stages[] = {compiled(gl, ShaderStage::vertex, vertex, program.warnings),
                           compiled(gl, ShaderStage::fragment, fragment, program.warnings)};
  program.name = gl.CreateProgram();
  for (const GLuint stage : stages) gl.AttachShader(program.name, stage);
  for (GLuint i = 0; i < std::size(own_attributes); ++i)
    gl.BindAttribLocation(program.name, i, own_attributes[i].data());
  bool good = linked(gl, program.name);
  if (good) good = move_attributes(gl, program);

  const std::string files = vertex.file + " + " + fragment.file;
  GLint length = 0;
  gl.GetProgramiv(program.name, GL_INFO_LOG_LENGTH, &length);
  const std::string log =
      log_of(length, [&](GLsizei room, GLchar* out) { gl.GetProgramInfoLog(program.name, room, nullptr, out); });
  std::vector<InputFault> faults;
  for (const LogLine& line : parse_log(log))
    if (good) program.warnings.push_back(warning_text(files, line, "the linker"));
    else faults.push_back({files, line.line, line.column, "", line.message, ""});
  if (good) return program;
  if (faults.empty()) faults.push_back({files, 0, 0, "", "shaders that do not link", "a program"});
  throw InputError(std::move(faults));
}

} // namespace refraster
