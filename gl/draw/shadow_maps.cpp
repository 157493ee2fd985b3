#include "gl/draw/shadow_maps.h"

#include "gl/context/gl_errors.h"
#include "gl/draw/uniforms.h"
#include "gl/draw/upload.h"
#include "gl/program/program.h"
#include "gl/render_gl.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>

namespace refraster {
namespace {

constexpr const char* vertex_text = "#version 330 core\n"
                                    "layout(location = 0) in vec3 vPos;\n"
                                    "uniform mat4 clipFromObject;\n"
                                    "void main() { gl_Position = clipFromObject * vec4(vPos, 1.0); }\n";
constexpr const char* fragment_text = "#version 330 core\nvoid main() {}\n";

/// The attribute that a map needs: positions, which come first.
constexpr unsigned only_positions = 1;

void check_size(const GlApi& gl, int side, std::size_t layers) {
  GLint max_side = 0, max_layers = 0;
  gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &max_side);
  gl.GetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &max_layers);
  if (side > max_side)
    throw NoOpenGl("a shadow map of " + std::to_string(side) +
                   " texels a side is too large for this OpenGL, whose textures have at most " +
                   std::to_string(max_side));
  if (layers > static_cast<std::size_t>(max_layers))
    throw NoOpenGl("the scene's lights have " + std::to_string(layers) +
                   " images of shadow maps, six for each point light: this OpenGL holds at most " +
                   std::to_string(max_layers));
}

GLuint new_maps(const GlApi& gl, int side, std::size_t layers) {
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.ActiveTexture(GL_TEXTURE0 + shadow_unit);
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, texture);
  gl.TexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT32F, side, side, static_cast<GLsizei>(layers), 0,
                GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  const auto set = [&](GLenum parameter, GLenum value) {
    gl.TexParameteri(GL_TEXTURE_2D_ARRAY, parameter, static_cast<GLint>(value));
  };
  set(GL_TEXTURE_MIN_FILTER, GL_NEAREST), set(GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  set(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE), set(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  set(GL_TEXTURE_MAX_LEVEL, 0);
  return texture;
}

/// The same texture for sampler2DArrayShadow.
void bind_compared(const GlApi& gl, GLuint texture) {
  GLuint sampler = 0;
  gl.GenSamplers(1, &sampler);
  const auto set = [&](GLenum parameter, GLenum value) {
    gl.SamplerParameteri(sampler, parameter, static_cast<GLint>(value));
  };
  set(GL_TEXTURE_MIN_FILTER, GL_LINEAR), set(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  set(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE), set(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  set(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE), set(GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  gl.ActiveTexture(GL_TEXTURE0 + compared_shadow_unit);
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, texture);
  gl.BindSampler(compared_shadow_unit, sampler);
  gl.ActiveTexture(GL_TEXTURE0);
}

/// What is drawn to before and after.
class KeptTarget {
public:
  explicit KeptTarget(const GlApi& gl) : gl_(gl) {
    gl.GetIntegerv(GL_FRAMEBUFFER_BINDING, &framebuffer_);
    gl.GetIntegerv(GL_VIEWPORT, viewport_.data());
  }
  ~KeptTarget() {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(framebuffer_));
    gl_.Viewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
  }
  KeptTarget(const KeptTarget&) = delete;
  KeptTarget& operator=(const KeptTarget&) = delete;

private:
  const GlApi& gl_;
  GLint framebuffer_ = 0;
  std::array<GLint, 4> viewport_{};
};

} // namespace

void draw_shadow_maps(const GlApi& gl, const Scene& scene, std::span<const LightView> views) {
  int side = 0;
  std::size_t layers = 0;
  for (const LightView& view : views) side = std::max(side, view.map.size), layers += view.faces();
  check_size(gl, side, layers);
  const KeptTarget target(gl);
  const GLuint texture = new_maps(gl, side, layers);
  GLuint framebuffer = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
  const GlProgram program = link_program(gl, {"our vertex shader of shadow maps", vertex_text},
                                         {"our fragment shader of shadow maps", fragment_text});
  gl.UseProgram(program.name);
  const GLint clip_from_object = gl.GetUniformLocation(program.name, "clipFromObject");
  std::map<const Mesh*, GLuint> meshes;
  for (const Object& object : scene.objects)
    if (const auto [at, is_new] = meshes.try_emplace(object.mesh.get()); is_new)
      at->second = upload_mesh(gl, *object.mesh, only_positions);
  gl.Disable(GL_CULL_FACE);
  gl.ClearDepth(1);
  GLint layer = 0;
  for (const LightView& view : views)
    for (std::size_t face = 0; face < view.faces(); ++face) {
      gl.FramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, texture, 0, layer++);
      gl.Viewport(0, 0, side, side);
      gl.Clear(GL_DEPTH_BUFFER_BIT);
      gl.Viewport(0, 0, view.map.size, view.map.size);
      const Double4x4 clip_from_world = view.viewpoint(face).clip_from_world;
      for (const Object& object : scene.objects) {
        set_uniform(gl, {clip_from_object, Float4x4(object_transform(object, clip_from_world).clip_from_object)});
        gl.BindVertexArray(meshes[object.mesh.get()]);
        gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * object.mesh->triangles.size()), GL_UNSIGNED_INT,
                        nullptr);
      }
    }
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw NoOpenGl("this OpenGL does not draw to layers of GL_DEPTH_COMPONENT32F");
  bind_compared(gl, texture);
  throw_if_error(gl, "drawing the shadow maps");
}

} // namespace refraster
