// Probes a browser's WebGL 2 with the probes of `refraster gl --probe`, and compares what is found with a profile:
//     probe_web PROFILE DRIVER
// It is an OpenGL whose calls are lines on standard output, JSON arrays of a name and arguments, which a page carries
// out (probe.html); those that begin with "?" are answered on standard input, by eight bytes that give a length, the
// lowest first, and so many bytes. The last line is the table of what was found. Exit 1 if the profile is tighter, or
// more than twice as wide.

#include "gl/probe/probe_api.h"
#include "tests/support/gl/profile_relation.h"
#include "verify/device/profile_markdown.h"
#include "verify/device/read_profile.h"

#include <concepts>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace {

using namespace refraster;

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text)
    if (c == '\n') result += "\\n";
    else if (c == '"' || c == '\\') result += '\\', result += c;
    else result += c;
  return result + '"';
}

/// Bytes as hexadecimal digits.
std::string bytes_text(const void* data, std::size_t size_bytes) {
  std::string result = "\"";
  for (std::size_t i = 0; i < size_bytes; ++i) {
    const auto byte = static_cast<const unsigned char*>(data)[i];
    result += "0123456789abcdef"[byte >> 4], result += "0123456789abcdef"[byte & 15];
  }
  return result + '"';
}

std::string text_of(std::string_view text) {
  return std::string(text);
}
std::string text_of(std::integral auto number) {
  return std::to_string(number);
}
std::string text_of(std::floating_point auto number) {
  return std::to_string(number);
}

void call(const char* name, const auto&... arguments) {
  std::string line = "[" + quoted(name);
  ((line += "," + text_of(arguments)), ...);
  std::puts((line + "]").c_str());
}

void read_exactly(void* to, std::size_t size_bytes) {
  if (std::fread(to, 1, size_bytes, stdin) != size_bytes) throw std::runtime_error("the page has gone");
}

/// Calls a function that is answered.
std::vector<unsigned char> ask(const char* name, const auto&... arguments) {
  call(name, arguments...);
  std::fflush(stdout);
  unsigned char size[8];
  read_exactly(size, sizeof size);
  std::size_t size_bytes = 0;
  for (int i = 7; i >= 0; --i) size_bytes = size_bytes << 8 | size[i];
  std::vector<unsigned char> answer(size_bytes);
  read_exactly(answer.data(), answer.size());
  return answer;
}

GLint ask_number(const char* name, const auto&... arguments) {
  const std::vector<unsigned char> answer = ask(name, arguments...);
  GLint number = 0;
  std::memcpy(&number, answer.data(), std::min(answer.size(), sizeof number));
  return number;
}

GLuint next_object = 1;

template <const char* name>
void APIENTRY generate(GLsizei count, GLuint* objects) {
  for (GLsizei i = 0; i < count; ++i) call(name, objects[i] = next_object++);
}
constexpr char create_vertex_array[] = "createVertexArray", create_buffer[] = "createBuffer",
               create_framebuffer[] = "createFramebuffer", create_renderbuffer[] = "createRenderbuffer",
               create_texture[] = "createTexture";

/// What the probes call, and no more. Errors of compilers stop the page.
GlApi web_api() {
  GlApi gl;
  gl.GenVertexArrays = generate<create_vertex_array>;
  gl.GenBuffers = generate<create_buffer>;
  gl.GenFramebuffers = generate<create_framebuffer>;
  gl.GenRenderbuffers = generate<create_renderbuffer>;
  gl.GenTextures = generate<create_texture>;
  gl.Enable = [](GLenum what) {
    if (what != GL_FRAMEBUFFER_SRGB) call("enable", what); // which WebGL has always on
  };
  gl.Disable = [](GLenum what) {
    if (what != GL_FRAMEBUFFER_SRGB) call("disable", what);
  };
  gl.DepthFunc = [](GLenum function) { call("depthFunc", function); };
  gl.PixelStorei = [](GLenum what, GLint value) { call("pixelStorei", what, value); };
  gl.Viewport = [](GLint x, GLint y, GLsizei width, GLsizei height) { call("viewport", x, y, width, height); };
  gl.BindVertexArray = [](GLuint array) { call("bindVertexArray", array); };
  gl.BindBuffer = [](GLenum target, GLuint buffer) { call("bindBuffer", target, buffer); };
  gl.BufferData = [](GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
    call("bufferData", target, bytes_text(data, static_cast<std::size_t>(size)), usage);
  };
  gl.VertexAttribPointer = [](GLuint place, GLint count, GLenum type, GLboolean, GLsizei stride, const void* offset) {
    call("vertexAttribPointer", place, count, type, stride, reinterpret_cast<std::uintptr_t>(offset));
  };
  gl.EnableVertexAttribArray = [](GLuint place) { call("enableVertexAttribArray", place); };
  gl.BindFramebuffer = [](GLenum target, GLuint framebuffer) { call("bindFramebuffer", target, framebuffer); };
  gl.BindRenderbuffer = [](GLenum target, GLuint renderbuffer) { call("bindRenderbuffer", target, renderbuffer); };
  gl.RenderbufferStorage = [](GLenum target, GLenum format, GLsizei width, GLsizei height) {
    call("renderbufferStorage", target, format, width, height);
  };
  gl.FramebufferRenderbuffer = [](GLenum target, GLenum place, GLenum kind, GLuint renderbuffer) {
    call("framebufferRenderbuffer", target, place, kind, renderbuffer);
  };
  gl.CheckFramebufferStatus = [](GLenum target) {
    return static_cast<GLenum>(ask_number("?checkFramebufferStatus", target));
  };
  gl.GetIntegerv = [](GLenum what, GLint* value) { *value = ask_number("?getParameter", what); };
  gl.GetError = [] { return static_cast<GLenum>(ask_number("?getError")); };
  gl.ClearBufferfv = [](GLenum buffer, GLint drawn, const GLfloat* v) {
    if (buffer == GL_DEPTH) call("clearBufferfv", buffer, drawn, v[0]);
    else call("clearBufferfv", buffer, drawn, v[0], v[1], v[2], v[3]);
  };
  gl.DrawElements = [](GLenum mode, GLsizei count, GLenum type, const void*) {
    call("drawElements", mode, count, type, 0);
  };
  gl.ReadPixels = [](GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type, void* pixels) {
    const std::vector<unsigned char> answer = ask("?readPixels", x, y, width, height, format, type);
    std::memcpy(pixels, answer.data(), answer.size());
  };
  gl.BindTexture = [](GLenum target, GLuint texture) { call("bindTexture", target, texture); };
  gl.TexParameteri = [](GLenum target, GLenum what, GLint value) { call("texParameteri", target, what, value); };
  gl.TexImage2D = [](GLenum target, GLint level, GLint stored, GLsizei width, GLsizei height, GLint, GLenum format,
                     GLenum type, const void* data) {
    call("texImage2D", target, level, stored, width, height, format, type,
         bytes_text(data, static_cast<std::size_t>(3 * width * height)));
  };
  gl.CreateShader = [](GLenum type) {
    call("createShader", next_object, type);
    return next_object++;
  };
  gl.ShaderSource = [](GLuint shader, GLsizei, const GLchar* const* text, const GLint* size) {
    std::string glsl(*text, static_cast<std::size_t>(*size));
    const std::string first = "#version 330 core\n";
    glsl.replace(0, first.size(), "#version 300 es\nprecision highp float;\nprecision highp int;\n");
    call("shaderSource", shader, quoted(glsl));
  };
  gl.CompileShader = [](GLuint shader) { call("compileShader", shader); };
  gl.GetShaderiv = [](GLuint, GLenum what, GLint* value) { *value = what == GL_COMPILE_STATUS ? GL_TRUE : 0; };
  gl.CreateProgram = [] {
    call("createProgram", next_object);
    return next_object++;
  };
  gl.AttachShader = [](GLuint program, GLuint shader) { call("attachShader", program, shader); };
  gl.BindAttribLocation = [](GLuint program, GLuint place, const GLchar* name) {
    call("bindAttribLocation", program, place, quoted(name));
  };
  gl.LinkProgram = [](GLuint program) { call("linkProgram", program); };
  gl.GetProgramiv = [](GLuint, GLenum what, GLint* value) { *value = what == GL_LINK_STATUS ? GL_TRUE : 0; };
  gl.UseProgram = [](GLuint program) { call("useProgram", program); };
  return gl;
}

} // namespace

int main(int argc, char** argv) try {
  if (argc != 3) {
    std::fprintf(stderr, "usage: probe_web PROFILE DRIVER\n");
    return 2;
  }
  const DeviceProfile expected = device_profile(argv[1]);
  const DeviceProfile measured = measured_profile(probe_device(web_api(), {"", argv[2], "WebGL 2", ""}), "measured");
  call("finish", quoted(measured_markdown(measured, expected)));
  const std::vector<std::string> faults = relation_faults(measured, expected);
  for (const std::string& fault : faults) std::fprintf(stderr, "%s\n", fault.c_str());
  return faults.empty() ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
