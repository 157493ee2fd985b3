#include "gl/draw/dummy_textures.h"

#include "gl/program/glsl_types.h"

#include <cstdint>

namespace refraster {
namespace {

/// How a texel of a base type is stored. The channels that a format lacks are read as 0, alpha as 1.
struct Texel {
  GLint format;
  GLenum layout, component;
};
Texel texel_of(GlslBase base) {
  switch (base) {
  case GlslBase::int_:
    return {GL_R8I, GL_RED_INTEGER, GL_BYTE};
  case GlslBase::uint_:
    return {GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE};
  case GlslBase::depth:
    return {GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT};
  default:
    return {GL_R8, GL_RED, GL_UNSIGNED_BYTE};
  }
}

/// Samples can only be drawn to, not uploaded.
void clear_samples(const GlApi& gl, GLuint texture, GlslBase base) {
  GLint before = 0;
  gl.GetIntegerv(GL_FRAMEBUFFER_BINDING, &before);
  GLuint framebuffer = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.FramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture, 0);
  constexpr GLfloat floats[4] = {};
  constexpr GLint ints[4] = {};
  constexpr GLuint uints[4] = {};
  if (base == GlslBase::int_) gl.ClearBufferiv(GL_COLOR, 0, ints);
  else if (base == GlslBase::uint_) gl.ClearBufferuiv(GL_COLOR, 0, uints);
  else gl.ClearBufferfv(GL_COLOR, 0, floats);
  gl.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(before));
  gl.DeleteFramebuffers(1, &framebuffer);
}

/// One texel of depth 1, or of zeros, in each face.
void fill(const GlApi& gl, const GlslType& type, GLuint texture) {
  const Texel texel = texel_of(type.base);
  const std::uint32_t value = type.base == GlslBase::depth ? 0xFFFFFFFFu : 0u;
  const std::uint32_t values[6] = {value, value, value, value, value, value};
  const GLenum target = type.target;
  switch (target) {
  case GL_TEXTURE_BUFFER: {
    GLuint buffer = 0;
    gl.GenBuffers(1, &buffer);
    gl.BindBuffer(GL_TEXTURE_BUFFER, buffer);
    gl.BufferData(GL_TEXTURE_BUFFER, sizeof values, values, GL_STATIC_DRAW);
    gl.TexBuffer(target, static_cast<GLenum>(texel.format), buffer);
    return;
  }
  case GL_TEXTURE_2D_MULTISAMPLE:
    gl.TexImage2DMultisample(target, 1, static_cast<GLenum>(texel.format), 1, 1, GL_TRUE);
    return clear_samples(gl, texture, type.base);
  case GL_TEXTURE_2D_MULTISAMPLE_ARRAY:
    gl.TexImage3DMultisample(target, 1, static_cast<GLenum>(texel.format), 1, 1, 1, GL_TRUE);
    return clear_samples(gl, texture, type.base);
  case GL_TEXTURE_1D:
    gl.TexImage1D(target, 0, texel.format, 1, 0, texel.layout, texel.component, values);
    break;
  case GL_TEXTURE_CUBE_MAP:
    for (GLenum face = 0; face < 6; ++face)
      gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, texel.format, 1, 1, 0, texel.layout, texel.component,
                    values);
    break;
  case GL_TEXTURE_3D:
  case GL_TEXTURE_2D_ARRAY:
  case GL_TEXTURE_CUBE_MAP_ARRAY:
    gl.TexImage3D(target, 0, texel.format, 1, 1, target == GL_TEXTURE_CUBE_MAP_ARRAY ? 6 : 1, 0, texel.layout,
                  texel.component, values);
    break;
  default: // 2D, rectangle, 1D array
    gl.TexImage2D(target, 0, texel.format, 1, 1, 0, texel.layout, texel.component, values);
    break;
  }
  gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  if (target != GL_TEXTURE_RECTANGLE) gl.TexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
  if (type.base == GlslBase::depth) {
    gl.TexParameteri(target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    gl.TexParameteri(target, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  }
}

} // namespace

GLint DummyTextures::unit_of(GLenum sampler_type) {
  const auto [entry, is_new] = units_.try_emplace(sampler_type, first_unit_ + static_cast<GLint>(units_.size()));
  if (!is_new) return entry->second;
  const GlslType& type = glsl_type(sampler_type);
  GLuint texture = 0;
  gl_.GenTextures(1, &texture);
  gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(entry->second));
  gl_.BindTexture(type.target, texture);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  fill(gl_, type, texture);
  gl_.ActiveTexture(GL_TEXTURE0);
  return entry->second;
}

} // namespace refraster
