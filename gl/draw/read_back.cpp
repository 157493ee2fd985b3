#include "gl/draw/read_back.h"

#include "gl/program/program.h"

#include <algorithm>
#include <cstddef>

namespace refraster {
namespace {

constexpr GLenum formats[] = {GL_NONE, GL_RED, GL_RG, GL_RGB, GL_RGBA}; // by the number of channels

/// Of the current framebuffer.
template <class Value>
Image<Value> read_pixels(const GlApi& gl, const GlTarget& target, GLenum format, int channels) {
  Image<Value> image(target.width, target.height, channels);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, target.width, target.height, format, sizeof(Value) == 1 ? GL_UNSIGNED_BYTE : GL_FLOAT,
                image.values.data());
  const auto row_values = static_cast<std::ptrdiff_t>(target.width) * channels;
  for (int top = 0, bottom = target.height - 1; top < bottom; ++top, --bottom) {
    const auto row = image.values.begin() + top * row_values;
    std::swap_ranges(row, row + row_values, image.values.begin() + bottom * row_values);
  }
  return image;
}

/// A framebuffer of one sample a pixel, current as long as this lives; then the target is again.
class SinglePixels {
public:
  SinglePixels(const GlApi& gl, const GlTarget& target, GLenum format) : gl_(gl), target_(target) {
    gl.GenFramebuffers(1, &framebuffer_);
    bind();
    gl.GenRenderbuffers(1, &colour_);
    gl.BindRenderbuffer(GL_RENDERBUFFER, colour_);
    gl.RenderbufferStorage(GL_RENDERBUFFER, format, target.width, target.height);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      throw NoOpenGl("this OpenGL cannot resolve an image of several samples a pixel");
  }
  void bind() const { gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_); }
  ~SinglePixels() {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, target_.framebuffer);
    gl_.DeleteFramebuffers(1, &framebuffer_);
    gl_.DeleteRenderbuffers(1, &colour_);
  }
  SinglePixels(const SinglePixels&) = delete;
  SinglePixels& operator=(const SinglePixels&) = delete;

private:
  const GlApi& gl_;
  const GlTarget& target_;
  GLuint framebuffer_ = 0, colour_ = 0;
};

template <class Value>
Image<Value> read_resolved(const GlApi& gl, const GlTarget& target) {
  if (target.samples == 1) return read_pixels<Value>(gl, target, GL_RGB, 3);
  const SinglePixels single(gl, target, target.colour_format);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, target.framebuffer);
  gl.BlitFramebuffer(0, 0, target.width, target.height, 0, 0, target.width, target.height, GL_COLOR_BUFFER_BIT,
                     GL_NEAREST);
  single.bind();
  return read_pixels<Value>(gl, target, GL_RGB, 3);
}

/// One triangle over the whole window.
const ShaderText vertex_shader{"our vertex shader of samples", R"(#version 330 core
void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
)"};
const ShaderText fragment_shader{"our fragment shader of samples", R"(#version 330 core
uniform sampler2DMS samples;
uniform int number;
out vec4 FragColor;
void main() {
    FragColor = texelFetch(samples, ivec2(gl_FragCoord.xy), number);
}
)"};

// A blit would mix the samples of colours; and which one it takes of depth is the driver's choice.
Image<float> read_texture(const GlApi& gl, const GlTarget& target, GLuint texture, int sample, int channels) {
  const SinglePixels single(gl, target, GL_RGBA32F);
  const GLuint program = link_program(gl, vertex_shader, fragment_shader).name;
  gl.UseProgram(program);
  gl.Uniform1i(gl.GetUniformLocation(program, "samples"), 0);
  gl.Uniform1i(gl.GetUniformLocation(program, "number"), sample);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.Disable(GL_CULL_FACE); // there is no depth to be tested
  GLuint no_arrays = 0;
  gl.GenVertexArrays(1, &no_arrays);
  gl.BindVertexArray(no_arrays);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
  return read_pixels<float>(gl, target, formats[channels], channels);
}

} // namespace

Image<std::uint8_t> read_rgb8(const GlApi& gl, const GlTarget& target) {
  return read_resolved<std::uint8_t>(gl, target);
}
Image<float> read_radiance(const GlApi& gl, const GlTarget& target) {
  return read_resolved<float>(gl, target);
}

Image<float> read_sample(const GlApi& gl, const GlTarget& target, int sample, int channels) {
  if (target.samples == 1) return read_pixels<float>(gl, target, formats[channels], channels);
  return read_texture(gl, target, target.colour, sample, channels);
}
Image<float> read_sample_depth(const GlApi& gl, const GlTarget& target, int sample) {
  if (target.samples == 1) return read_pixels<float>(gl, target, GL_DEPTH_COMPONENT, 1);
  return read_texture(gl, target, target.depth, sample, 1);
}

} // namespace refraster
