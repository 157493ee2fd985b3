#include "gl/probe/probe_canvas.h"

#include "gl/context/gl_errors.h"
#include "gl/context/target.h"
#include "gl/program/program.h"

#include <cstddef>
#include <numeric>

namespace refraster {
namespace {

const char* const vertex_shader = "#version 330 core\n"
                                  "in vec4 vPos;\n"
                                  "in vec4 vNormal;\n"
                                  "out vec4 v;\n"
                                  "void main() { gl_Position = vPos; v = vNormal; }\n";

} // namespace

ProbeCanvas::ProbeCanvas(const GlApi& gl) : gl_(gl) {
  constexpr GLenum switched_off[] = {GL_DITHER, GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST};
  for (const GLenum capability : switched_off) gl.Disable(capability);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  GLuint array = 0;
  gl.GenVertexArrays(1, &array);
  gl.BindVertexArray(array);
  gl.GenBuffers(2, buffers_);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
  constexpr auto stride = static_cast<GLsizei>(sizeof(ProbeVertex));
  gl.VertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, stride, nullptr);
  gl.VertexAttribPointer(1, 4, GL_FLOAT, GL_FALSE, stride, reinterpret_cast<const void*>(offsetof(ProbeVertex, data)));
  for (const GLuint attribute : {0U, 1U}) gl.EnableVertexAttribArray(attribute);
}

void ProbeCanvas::set_target(GLenum colour_format, int width, int height) {
  GlOptions options;
  options.width = width_ = width, options.height = height_ = height;
  make_target(gl_, colour_format, options);
}

GLuint ProbeCanvas::program(const std::string& body, const std::string& declarations) const {
  const std::string fragment = "#version 330 core\nin vec4 v;\nout vec4 colour;\n" + declarations +
                               "void main() {\n    vec4 result = vec4(0.0);\n" + body + "    colour = result;\n}\n";
  return link_program(gl_, {"the vertex shader of a probe", vertex_shader},
                      {"the fragment shader of a probe", fragment})
      .name;
}

void ProbeCanvas::clear(float value) const {
  const float colour[] = {value, value, value, value}, depth[] = {1};
  gl_.ClearBufferfv(GL_COLOR, 0, colour);
  gl_.ClearBufferfv(GL_DEPTH, 0, depth);
}

void ProbeCanvas::draw(GLuint program, const std::vector<ProbeVertex>& vertices) {
  std::vector<GLuint> indices(vertices.size());
  std::iota(indices.begin(), indices.end(), 0U);
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(ProbeVertex)), vertices.data(),
                 GL_STREAM_DRAW);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(GLuint)), indices.data(),
                 GL_STREAM_DRAW);
  gl_.UseProgram(program);
  gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, nullptr);
}

void ProbeCanvas::draw_all(GLuint program) {
  const auto corner = [](float x, float y) { return ProbeVertex{{2 * x - 1, 2 * y - 1, 0, 1}, {x, y, 0, 0}}; };
  draw(program, {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 0), corner(1, 1), corner(0, 1)});
}

std::vector<float> ProbeCanvas::read_floats() const {
  std::vector<float> values(4 * pixels());
  gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, values.data());
  return values;
}

std::vector<std::uint8_t> ProbeCanvas::read_bytes() const {
  std::vector<std::uint8_t> values(4 * pixels());
  gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, values.data());
  return values;
}

std::vector<float> ProbeCanvas::read_depth() const {
  std::vector<float> values(pixels());
  gl_.ReadPixels(0, 0, width_, height_, GL_DEPTH_COMPONENT, GL_FLOAT, values.data());
  return values;
}

std::vector<float> ProbeCanvas::evaluated(int width, int height, const std::string& body,
                                          const std::string& declarations) {
  set_target(GL_RGBA32F, width, height);
  clear(0);
  draw_all(program(body, declarations));
  return read_floats();
}

std::string pixel_number(int width) {
  return "    uint i = uint(gl_FragCoord.x) + " + std::to_string(width) + "u * uint(gl_FragCoord.y);\n";
}

void check_probe(const ProbeCanvas& canvas, const std::string& probe) {
  throw_if_error(canvas.gl(), "probing " + probe);
}

} // namespace refraster
