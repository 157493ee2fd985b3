#include "gl/context/target.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace refraster {
namespace {

constexpr GLenum depth_format = GL_DEPTH_COMPONENT32F;

void check_size(const GlApi& gl, const GlOptions& options) {
  GLint most = 0;
  gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
  if (options.width > most || options.height > most)
    throw NoOpenGl("an image of " + std::to_string(options.width) + " x " + std::to_string(options.height) +
                   " pixels is too large for this OpenGL, which draws at most " + std::to_string(most) + " a side");
}

/// Numbers of samples above 1 that textures of a format may have, rising. A driver that cannot be asked says the most.
std::vector<GLint> sample_counts(const GlApi& gl, GLenum format) {
  std::vector<GLint> counts;
  if (gl.GetInternalformativ) {
    GLint count = 0;
    gl.GetInternalformativ(GL_TEXTURE_2D_MULTISAMPLE, format, GL_NUM_SAMPLE_COUNTS, 1, &count);
    counts.resize(static_cast<std::size_t>(std::max(count, 0)));
    if (count > 0) gl.GetInternalformativ(GL_TEXTURE_2D_MULTISAMPLE, format, GL_SAMPLES, count, counts.data());
  } else {
    counts.resize(1);
    gl.GetIntegerv(format == depth_format ? GL_MAX_DEPTH_TEXTURE_SAMPLES : GL_MAX_COLOR_TEXTURE_SAMPLES, counts.data());
  }
  std::erase_if(counts, [](GLint samples) { return samples < 2; });
  std::sort(counts.begin(), counts.end());
  return counts;
}

[[noreturn]] void refuse_samples(const GlApi& gl, GLenum colour_format, int samples) {
  const std::vector<GLint> colour = sample_counts(gl, colour_format), depth = sample_counts(gl, depth_format);
  std::vector<GLint> both;
  std::set_intersection(colour.begin(), colour.end(), depth.begin(), depth.end(), std::back_inserter(both));
  std::string list = "1";
  int fewer = 1;
  for (const GLint count : both) {
    list += (count == both.back() ? " or " : ", ") + std::to_string(count);
    if (count < samples) fewer = count;
  }
  const GLubyte* const name = gl.GetString(GL_RENDERER);
  throw NoSuchSamples("this OpenGL (" + std::string(name ? reinterpret_cast<const char*>(name) : "without a name") +
                          ") does not draw " + std::to_string(samples) + " samples a pixel, but " + list,
                      samples, fewer);
}

GLuint multisample_texture(const GlApi& gl, GLenum format, const GlOptions& options) {
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture);
  // Fixed: the same positions in every pixel and in both attachments.
  gl.TexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, options.samples, format, options.width, options.height, GL_TRUE);
  gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
  return texture;
}

GLuint renderbuffer(const GlApi& gl, GLenum format, const GlOptions& options) {
  GLuint buffer = 0;
  gl.GenRenderbuffers(1, &buffer);
  gl.BindRenderbuffer(GL_RENDERBUFFER, buffer);
  gl.RenderbufferStorage(GL_RENDERBUFFER, format, options.width, options.height);
  return buffer;
}

} // namespace

GlTarget make_target(const GlApi& gl, GLenum colour_format, const GlOptions& options) {
  check_size(gl, options);
  GlTarget target{0, 0, 0, colour_format, options.width, options.height, options.samples};
  gl.GenFramebuffers(1, &target.framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  if (options.samples > 1) {
    for (const GLenum format : {colour_format, depth_format})
      if (const std::vector<GLint> counts = sample_counts(gl, format);
          std::find(counts.begin(), counts.end(), options.samples) == counts.end())
        refuse_samples(gl, colour_format, options.samples);
    target.colour = multisample_texture(gl, colour_format, options);
    target.depth = multisample_texture(gl, depth_format, options);
    gl.FramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target.colour, 0);
    gl.FramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, target.depth, 0);
  } else {
    target.colour = renderbuffer(gl, colour_format, options);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target.colour);
    target.depth = renderbuffer(gl, depth_format, options);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, target.depth);
  }
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw NoOpenGl("this OpenGL cannot draw to an image of that format and size");
  gl.Viewport(0, 0, options.width, options.height);
  return target;
}

std::vector<GlSamplePosition> sample_positions(const GlApi& gl, const GlTarget& target) {
  std::vector<GlSamplePosition> positions(static_cast<std::size_t>(target.samples));
  if (target.samples == 1) return positions;
  for (GLuint i = 0; i < positions.size(); ++i) {
    GLfloat place[2] = {}; // y upward
    gl.GetMultisamplefv(GL_SAMPLE_POSITION, i, place);
    positions[i] = {static_cast<double>(place[0]), 1 - static_cast<double>(place[1])};
  }
  return positions;
}

} // namespace refraster
