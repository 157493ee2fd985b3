#include "verify/gl/drawing.h"

#include "verify/gl/own_glsl.h"
#include "verify/gl/shader_choice.h"
#include "verify/gl/upload.h"

#include <cstdio>

namespace refraster {
namespace {

constexpr GLuint matrices_binding = 0;

const std::string ids_glsl = R"(#version 330 core
uniform float objectNumber;
uniform float triangleNumber;
out vec4 FragColor;
void main() {
    FragColor = vec4(objectNumber, triangleNumber, 0.0, 1.0);
}
)";

/// Binds the block Matrices; a warning for any other block, or one that is laid out in another way.
void bind_blocks(const GlApi& gl, GLuint program, std::vector<std::string>& warnings) {
  GLint blocks = 0;
  gl.GetProgramiv(program, GL_ACTIVE_UNIFORM_BLOCKS, &blocks);
  for (GLuint i = 0; i < static_cast<GLuint>(blocks); ++i) {
    GLchar name[256] = {};
    GLint size_bytes = 0;
    gl.GetActiveUniformBlockName(program, i, sizeof name, nullptr, name);
    gl.GetActiveUniformBlockiv(program, i, GL_UNIFORM_BLOCK_DATA_SIZE, &size_bytes);
    if (std::string(name) != "Matrices") {
      warnings.push_back(std::string("uniform block ") + name + " is not one that refraster sets");
      continue;
    }
    if (size_bytes != static_cast<GLint>(sizeof(MatricesBlock)))
      warnings.push_back("uniform block Matrices: found " + std::to_string(size_bytes) + " bytes, expected " +
                         std::to_string(sizeof(MatricesBlock)) + ": layout (std140), mat4 view, mat4 projection");
    gl.UniformBlockBinding(program, i, matrices_binding);
  }
}

/// 330 for a driver that says "3.30 …".
int newest_glsl(const GlApi& gl) {
  const char* const words = reinterpret_cast<const char*>(gl.GetString(GL_SHADING_LANGUAGE_VERSION));
  int major = 3, minor = 30;
  if (words) std::sscanf(words, "%d.%d", &major, &minor);
  return 100 * major + minor;
}

/// shared[key], made when it is first asked for.
template <class Key, class Make>
GLuint once(std::map<Key, GLuint>& shared, const Key& key, Make&& make) {
  const auto [entry, is_new] = shared.try_emplace(key);
  if (is_new) entry->second = make();
  return entry->second;
}

/// Of a triangle's indices in the buffer, as DrawElements takes it.
const void* place_of(std::size_t triangle) {
  return reinterpret_cast<const void*>(triangle * 3 * sizeof(std::uint32_t));
}

} // namespace

GlDrawing::GlDrawing(const GlApi& gl, const Scene& scene, const GlOptions& options)
    : gl_(gl), background_(scene.background), white_(upload_white(gl)) {
  const double aspect = static_cast<double>(options.width) / options.height;
  GLuint matrices = 0;
  const MatricesBlock block = matrices_block(scene.camera, aspect);
  gl.GenBuffers(1, &matrices);
  gl.BindBuffer(GL_UNIFORM_BUFFER, matrices);
  gl.BufferData(GL_UNIFORM_BUFFER, sizeof block, &block, GL_STATIC_DRAW);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, matrices_binding, matrices);

  const Double4x4 clip = flipped_clip_from_world(scene.camera, aspect);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) items_.push_back(item(scene, i, options, clip));

  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LESS);
  gl.FrontFace(GL_CW); // y is turned over, and with it what runs counter-clockwise
  gl.CullFace(GL_BACK);
}

GLuint GlDrawing::linked(const ShaderText& vertex, const ShaderText& fragment, const std::string& object) {
  for (const auto& [v, f, name] : programs_)
    if (v == vertex && f == fragment) return name;
  GlProgram program = link_program(gl_, vertex, fragment);
  bind_blocks(gl_, program.name, program.warnings);
  for (const std::string& warning : program.warnings) warnings_.push_back(object + ": " + warning);
  programs_.emplace_back(vertex, fragment, program.name);
  return program.name;
}

// Whatever a shader does with its texture, white is what it gets where there are no coordinates to read another at. The
// order of triangles stays: of equally near ones the first is seen.
std::vector<GlDrawing::TextureRun> GlDrawing::texture_runs(const Mesh& mesh, GLuint texture, GLuint white) {
  if (texture == white || mesh.uvs.size() == mesh.positions.size()) return {{texture, 0, mesh.triangles.size()}};
  std::vector<TextureRun> runs;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const GLuint here = has_uvs(mesh, mesh.triangles[i]) ? texture : white;
    if (runs.empty() || runs.back().texture != here) runs.push_back({here, i, 0});
    ++runs.back().triangles;
  }
  return runs;
}

GlDrawing::Item GlDrawing::item(const Scene& scene, std::size_t number, const GlOptions& options,
                                const Double4x4& clip_from_world) {
  const Object& object = scene.objects[number];
  Item item;
  item.cull = object.cull;
  item.vertices = once(meshes_, object.mesh.get(), [&] { return upload_mesh(gl_, *object.mesh); });
  GLuint shown = white_;
  if (const Texture* const texture = object.material.texture.get())
    shown = once(textures_, {texture, object.material.texture_filter},
                 [&] { return upload_texture(gl_, *texture, object.material.texture_filter); });
  item.runs = texture_runs(*object.mesh, shown, white_);
  if (const Merl* const merl = std::get_if<Merl>(&object.material.model))
    item.table = once(tables_, {merl->table.get(), merl->lookup}, [&] {
      const TableContent content = reads_logarithms(merl->lookup) ? TableContent::logarithms : TableContent::values;
      return upload_table(gl_, *merl->table, content, merl->lookup);
    });

  const ShaderChoice choice = choose_shaders(scene, object, options.merl_filter, newest_glsl(gl_));
  shaders_.push_back(choice.why);
  UniformValues values = scene_uniforms(scene);
  values.merge(object_uniforms(object, clip_from_world));
  const std::size_t colour = static_cast<std::size_t>(GlPass::colour), ids = static_cast<std::size_t>(GlPass::ids);
  item.program[colour] = linked(choice.vertex, choice.fragment, object.name);
  std::vector<std::string> warnings;
  item.uniforms[colour] = settings(gl_, item.program[colour], values, warnings);
  for (const std::string& warning : warnings) warnings_.push_back(object.name + ": " + warning);
  if (options.want_ids) {
    values["objectNumber"] = static_cast<float>(number + 1);
    values["triangleNumber"] = 0.0f; // set for each
    item.program[ids] = linked(choice.vertex, {"our fragment shader of ids", ids_glsl}, object.name);
    warnings.clear(); // the colour pass has told them
    item.uniforms[ids] = settings(gl_, item.program[ids], values, warnings);
    item.triangle_number = gl_.GetUniformLocation(item.program[ids], "triangleNumber");
  }
  return item;
}

void GlDrawing::draw(GlPass pass) const {
  const Float3 background = pass == GlPass::colour ? Float3(background_) : Float3(0);
  const auto p = static_cast<std::size_t>(pass);
  gl_.ClearColor(background.x, background.y, background.z, 1);
  gl_.ClearDepth(1);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (const Item& item : items_) {
    if (item.cull == Cull::back) gl_.Enable(GL_CULL_FACE);
    else gl_.Disable(GL_CULL_FACE);
    gl_.UseProgram(item.program[p]);
    for (const UniformSetting& uniform : item.uniforms[p]) set_uniform(gl_, uniform);
    gl_.ActiveTexture(GL_TEXTURE0 + merl_unit);
    gl_.BindTexture(GL_TEXTURE_3D, item.table);
    gl_.ActiveTexture(GL_TEXTURE0 + texture_unit);
    gl_.BindVertexArray(item.vertices);
    for (const TextureRun& run : item.runs) {
      gl_.BindTexture(GL_TEXTURE_2D, run.texture);
      if (pass == GlPass::colour)
        gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * run.triangles), GL_UNSIGNED_INT,
                         place_of(run.first_triangle));
      else draw_each(item, run);
    }
  }
}

// gl_PrimitiveID would be the way, but Mesa's softpipe has none in fragment shaders.
void GlDrawing::draw_each(const Item& item, const TextureRun& run) const {
  for (std::size_t i = run.first_triangle; i < run.first_triangle + run.triangles; ++i) {
    gl_.Uniform1f(item.triangle_number, static_cast<float>(i + 1));
    gl_.DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, place_of(i));
  }
}

} // namespace refraster
