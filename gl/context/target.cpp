#include "gl/context/target.h"

#include <cstddef>

namespace refraster {
namespace {

void check_size(const GlApi& gl, const GlOptions& options) {
  GLint most = 0;
  gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
  if (options.width > most || options.height > most)
    throw NoOpenGl("an image of " + std::to_string(options.width) + " x " + std::to_string(options.height) +
                   " pixels is too large for this OpenGL, which draws at most " + std::to_string(most) + " a side");
}

} // namespace

void make_target(const GlApi& gl, GLenum colour_format, const GlOptions& options) {
  check_size(gl, options);
  GLuint framebuffer = 0, buffers[2] = {};
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.GenRenderbuffers(2, buffers);
  const GLenum formats[] = {colour_format, GL_DEPTH_COMPONENT32F},
               places[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
  for (std::size_t i = 0; i < 2; ++i) {
    gl.BindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
    gl.RenderbufferStorage(GL_RENDERBUFFER, formats[i], options.width, options.height);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, places[i], GL_RENDERBUFFER, buffers[i]);
  }
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw NoOpenGl("this OpenGL cannot draw to an image of that format and size");
  gl.Viewport(0, 0, options.width, options.height);
}

} // namespace refraster
