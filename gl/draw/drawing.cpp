#include "gl/draw/drawing.h"

#include <refraster/notes.h>

#include "gl/context/gl_errors.h"
#include "gl/draw/upload.h"
#include "gl/drawn_by_gl.h"
#include "gl/glsl/own_glsl.h"
#include "gl/glsl/shader_choice.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace refraster {
namespace {

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

void set_constant(const GlApi& gl, const ConstantAttribute& attribute) {
  if (attribute.base == GlslBase::int_) gl.VertexAttribI4i(attribute.location, 0, 0, 0, 1);
  else if (attribute.base == GlslBase::uint_) gl.VertexAttribI4ui(attribute.location, 0, 0, 0, 1);
  else if (attribute.base == GlslBase::double_ && gl.VertexAttribL4d)
    gl.VertexAttribL4d(attribute.location, 0, 0, 0, 1);
  else gl.VertexAttrib4f(attribute.location, 0, 0, 0, 1);
}

/// OpenGL did not draw: with the words of the driver why, where it has any.
[[noreturn]] void refuse(const GlApi& gl, const std::string& object, GLuint program, const ShaderText& vertex,
                         const ShaderText& fragment, GLenum error) {
  if (error == GL_OUT_OF_MEMORY) throw NoOpenGl("OpenGL reports " + error_name(error) + " while drawing " + object);
  std::string reason = validation_log(gl, program);
  throw InputError({vertex.file + " + " + fragment.file, 0, 0, "",
                    error_name(error) + " when " + object + " is drawn with them" +
                        (reason.empty() ? "" : " (" + std::move(reason) + ")"),
                    "shaders that OpenGL draws with"});
}

template <class Draw>
std::uint64_t samples_passed(const GlApi& gl, Draw&& draw) {
  GLuint query = 0, passed = 0;
  gl.GenQueries(1, &query);
  gl.BeginQuery(GL_SAMPLES_PASSED, query);
  draw();
  gl.EndQuery(GL_SAMPLES_PASSED);
  gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &passed);
  gl.DeleteQueries(1, &query);
  return passed;
}

/// Of a triangle's indices in the buffer, as DrawElements takes it.
const void* place_of(std::size_t triangle) {
  return reinterpret_cast<const void*>(triangle * 3 * sizeof(std::uint32_t));
}

} // namespace

GlDrawing::GlDrawing(const GlApi& gl, const Scene& scene, const GlOptions& options)
    : gl_(gl), background_(scene.background), shadow_views_(light_views(scene, 1)), dummies_(gl, first_dummy_unit) {
  check_drawn_by_gl({}, scene);
  for (std::size_t i = 0; i < texture_slots.size(); ++i) {
    const auto is_same = [&](const TextureSlot& slot) { return slot.blank == texture_slots[i].blank; };
    const auto first = static_cast<std::size_t>(std::find_if(texture_slots.begin(), texture_slots.end(), is_same) -
                                                texture_slots.begin());
    blank_[i] = first < i ? blank_[first] : upload_blank(gl, texture_slots[i].blank);
  }
  const double aspect = static_cast<double>(options.width) / options.height;
  const Double4x4 clip = clip_from_world(scene.camera, aspect);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) items_.push_back(item(scene, i, options, clip));
  upload_blocks(matrices_block(scene.camera, aspect));

  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LESS);
  gl.FrontFace(GL_CCW);
  gl.CullFace(GL_BACK);
  throw_if_error(gl, "uploading the scene");
  if (!shadow_views_.empty()) draw_shadow_maps(gl, scene, shadow_views_);
}

void GlDrawing::upload_blocks(const MatricesBlock& matrices) {
  std::vector<unsigned char> bytes(std::max(sizeof matrices, static_cast<std::size_t>(largest_block_bytes_)));
  const auto upload = [&](GLuint binding) {
    GLuint buffer = 0;
    gl_.GenBuffers(1, &buffer);
    gl_.BindBuffer(GL_UNIFORM_BUFFER, buffer);
    gl_.BufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
    gl_.BindBufferBase(GL_UNIFORM_BUFFER, binding, buffer);
  };
  upload(zeros_binding);
  std::memcpy(bytes.data(), &matrices, sizeof matrices);
  upload(matrices_binding);
}

const GlDrawing::Program& GlDrawing::linked(const ShaderText& vertex, const ShaderText& fragment, const Object& object,
                                            WarningList& warnings) {
  const Material& material = object.material;
  const std::size_t function =
      material.user_function ? std::variant_size_v<FragmentFunction> : material.fragment_function.index();
  for (const Program& program : programs_)
    if (program.vertex == vertex && program.fragment == fragment && program.function == function) return program;
  throw_if_error(gl_, "uploading the scene"); // asking about programs takes errors
  const GlProgram compiled = link_program(gl_, vertex, fragment);
  for (const std::string& warning : compiled.warnings) warnings.add(warning);

  std::vector<std::string> found;
  Program program{vertex, fragment, function, compiled.name, {}, {}, {}, {}, true};
  program.attributes = attribute_use(gl_, compiled, found);
  largest_block_bytes_ = std::max(largest_block_bytes_, bind_blocks(gl_, program.name, found));
  program.storage = storage_use(gl_, program.name, found);
  for (const StorageUse& use : program.storage)
    once(storage_, std::tuple(use.target, use.binding, use.size_bytes), [&] {
      GLuint buffer = 0;
      gl_.GenBuffers(1, &buffer);
      return buffer;
    });
  program.subroutines = subroutine_use(gl_, program.name, found);
  program.mask = colour_mask(gl_, program.name, found);
  program.has_position = vertex.text.find("gl_Position") != std::string::npos;
  if (!program.has_position) found.push_back("the vertex shader does not set gl_Position: nothing is drawn");
  for (const std::string& warning : found) warnings.add(object.name, warning);
  throw_if_error(gl_, "asking what " + vertex.file + " and " + fragment.file + " declare");
  programs_.push_back(std::move(program));
  return programs_.back();
}

GlDrawing::Part GlDrawing::part(const Object& object, const ShaderText& vertex, const ShaderText& fragment,
                                const UniformValues& values, WarningList& warnings) {
  Part part;
  part.program = &linked(vertex, fragment, object, warnings);
  const unsigned arrays = part.program->attributes.arrays;
  part.vertices = once(meshes_, {object.mesh.get(), arrays}, [&] { return upload_mesh(gl_, *object.mesh, arrays); });
  const std::string_view function = object.material.function_name();
  std::vector<std::string> found;
  part.uniforms = settings(gl_, part.program->name, values, function, dummies_, found);
  for (const std::string& warning : found) warnings.add(object.name, warning);
  return part;
}

// Whatever a shader does with its textures, blank ones are what it gets where there are no coordinates to read others
// at. The order of triangles stays: of equally near ones the first is seen.
void GlDrawing::add_runs(const Mesh& mesh, std::size_t surface, std::size_t begin, std::size_t end, Item& item) const {
  const SlotTextures& textures = item.surfaces[surface].textures;
  if (textures == blank_ || mesh.uvs.size() == mesh.positions.size())
    return item.runs.push_back({surface, textures, begin, end - begin});
  const std::size_t first = item.runs.size();
  for (std::size_t i = begin; i < end; ++i) {
    const SlotTextures& here = has_uvs(mesh, mesh.triangles[i]) ? textures : blank_;
    if (item.runs.size() == first || item.runs.back().textures != here) item.runs.push_back({surface, here, i, 0});
    ++item.runs.back().triangles;
  }
}

GlDrawing::Item GlDrawing::item(const Scene& scene, std::size_t number, const GlOptions& options,
                                const Double4x4& clip_from_world) {
  const Object& object = scene.objects[number];
  Item item;
  item.name = object.name;
  item.cull = object.cull;
  GLuint place = 0;
  for_each_vertex_attribute([&](const auto& attribute) {
    if ((object.mesh.get()->*attribute.values).empty()) item.missing.emplace_back(place, attribute.otherwise);
    ++place;
  });
  std::map<const Material*, std::size_t> surfaces;
  const auto surface_of = [&](const Material& material) {
    const auto [entry, is_new] = surfaces.try_emplace(&material, item.surfaces.size());
    if (is_new) {
      Object with_one = object; // as if all of it had this material
      with_one.material = material;
      with_one.materials.clear();
      item.surfaces.push_back(surface(scene, with_one, number, options, clip_from_world, item));
    }
    return entry->second;
  };
  const auto triangles = static_cast<std::uint32_t>(object.mesh->triangles.size());
  if (triangles == 0) surface_of(object.material); // its shaders are compiled all the same
  for (std::uint32_t begin = 0; begin < triangles;) {
    const MaterialRange range = material_range(object, begin);
    add_runs(*object.mesh, surface_of(*range.material), begin, range.end_triangle, item);
    begin = range.end_triangle;
  }
  return item;
}

GlDrawing::Surface GlDrawing::surface(const Scene& scene, const Object& object, std::size_t number,
                                      const GlOptions& options, const Double4x4& clip_from_world, Item& item) {
  Surface surface;
  for (std::size_t i = 0; i < texture_slots.size(); ++i) {
    const TextureMap& map = object.material.*texture_slots[i].map;
    surface.textures[i] = map.texture ? once(textures_, {map.texture.get(), map.filter, map.wrap},
                                             [&] { return upload_texture(gl_, map); })
                                      : blank_[i];
  }
  if (const Merl* const merl = object.material.measured())
    surface.table = once(tables_, {merl->table.get(), merl->lookup}, [&] {
      const TableContent content = reads_logarithms(merl->lookup) ? TableContent::logarithms : TableContent::values;
      return upload_table(gl_, *merl->table, content, merl->lookup);
    });

  const ShaderChoice choice = choose_shaders(scene, object, options.merl_filter, newest_glsl(gl_));
  if (shaders_.empty() || shaders_.back() != choice.why) shaders_.push_back(choice.why); // said once for all materials
  item.has_shaders_of_its_own = choice.vertex_of_scene || choice.fragment_of_scene;
  UniformValues values = scene_uniforms(scene, shadow_views_);
  values.merge(object_uniforms(object, clip_from_world));
  const std::size_t colour = static_cast<std::size_t>(GlPass::colour), ids = static_cast<std::size_t>(GlPass::ids);
  surface.parts[colour] = part(object, choice.vertex, choice.fragment, values, warnings_);
  WarningList said_before; // the colour pass has told them, and of our own there is nothing to be reported
  Material of_ids = object.material;
  // A vertex shader of the scene's that is not like ours gives no texture coordinates to read an opacity by.
  if (choice.vertex_of_scene && choice.vertex.text.find("VS_OUT") == std::string::npos) of_ids.opacity_map = {};
  const ShaderText ids_shader{"our fragment shader of ids", own_ids_glsl(*object.mesh, of_ids)};
  values["objectNumber"] = static_cast<float>(number + 1);
  values["triangleNumber"] = 0.0f; // set for each
  if (options.want_ids) {
    surface.parts[ids] = part(object, choice.vertex, ids_shader, values, said_before);
    surface.triangle_number = gl_.GetUniformLocation(surface.parts[ids].program->name, "triangleNumber");
  }
  if (item.has_shaders_of_its_own)
    surface.plain = part(object, {"our vertex shader", own_vertex_glsl(*object.mesh, GlslDialect::core_330)},
                         ids_shader, values, said_before);
  return surface;
}

void GlDrawing::clear(GlPass pass) const {
  const Float3 background = pass == GlPass::colour ? Float3(background_) : Float3(0);
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_.ClearColor(background.x, background.y, background.z, 1);
  gl_.ClearDepth(1);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

/// All that a draw depends on is set: no object's image depends on those drawn before, but for their depth.
void GlDrawing::prepare(const Item& item, const Surface& surface, const Part& part) const {
  const Program& program = *part.program;
  if (item.cull == Cull::back) gl_.Enable(GL_CULL_FACE);
  else gl_.Disable(GL_CULL_FACE);
  gl_.ColorMask(program.mask[0], program.mask[1], program.mask[2], GL_TRUE);
  gl_.UseProgram(program.name);
  for (const UniformSetting& uniform : part.uniforms) set_uniform(gl_, uniform);
  const auto call = [&](GLenum stage, const std::vector<GLuint>& subroutines) {
    if (!subroutines.empty())
      gl_.UniformSubroutinesuiv(stage, static_cast<GLsizei>(subroutines.size()), subroutines.data());
  };
  call(GL_VERTEX_SHADER, program.subroutines.vertex);
  call(GL_FRAGMENT_SHADER, program.subroutines.fragment);
  for (const StorageUse& use : program.storage) {
    const std::vector<unsigned char> zeros(static_cast<std::size_t>(use.size_bytes));
    gl_.BindBufferBase(use.target, use.binding, storage_.at({use.target, use.binding, use.size_bytes}));
    gl_.BufferData(use.target, use.size_bytes, zeros.data(), GL_DYNAMIC_DRAW);
  }
  gl_.ActiveTexture(GL_TEXTURE0 + merl_unit);
  gl_.BindTexture(GL_TEXTURE_3D, surface.table);
  gl_.BindVertexArray(part.vertices);
  for (const ConstantAttribute& attribute : program.attributes.constants) set_constant(gl_, attribute);
  for (const auto& [place, value] : item.missing)
    if ((program.attributes.arrays & 1u << place) != 0) gl_.VertexAttrib4f(place, value, value, value, 1);
}

void GlDrawing::draw_item(const Item& item, GlPass pass) const {
  draw_runs(
      item, [pass](const Surface& surface) -> const Part& { return surface.parts[static_cast<std::size_t>(pass)]; },
      [&](const Surface& surface, const Run& run) {
        if (pass == GlPass::colour) draw_run(run);
        else draw_each(surface, run);
      });
}

void GlDrawing::bind_textures(const SlotTextures& textures) const {
  for (std::size_t i = 0; i < textures.size(); ++i) {
    gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
    gl_.BindTexture(GL_TEXTURE_2D, textures[i]);
  }
}

template <class PartOf, class DrawRun>
void GlDrawing::draw_runs(const Item& item, const PartOf& part_of, const DrawRun& draw_run) const {
  const Surface* prepared = nullptr;
  for (const Run& run : item.runs) {
    const Surface& surface = item.surfaces[run.surface];
    const Part& part = part_of(surface);
    if (!part.program->has_position) continue;
    if (prepared != &surface) prepare(item, surface, part);
    prepared = &surface;
    bind_textures(run.textures);
    draw_run(surface, run);
  }
}

void GlDrawing::draw_run(const Run& run) const {
  gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * run.triangles), GL_UNSIGNED_INT,
                   place_of(run.first_triangle));
}

void GlDrawing::draw(GlPass pass) const {
  clear(pass);
  for (const Item& item : items_) draw_item(item, pass);
}

// gl_PrimitiveID would be the way, but Mesa's softpipe has none in fragment shaders.
void GlDrawing::draw_each(const Surface& surface, const Run& run) const {
  for (std::size_t i = run.first_triangle; i < run.first_triangle + run.triangles; ++i) {
    gl_.Uniform1f(surface.triangle_number, static_cast<float>(i + 1));
    gl_.DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, place_of(i));
  }
}

template <class PartOf>
std::uint64_t GlDrawing::samples_alone(const Item& item, const PartOf& part_of) const {
  clear(GlPass::colour);
  return samples_passed(gl_, [&] { draw_runs(item, part_of, [&](const Surface&, const Run& run) { draw_run(run); }); });
}

std::uint64_t GlDrawing::draw_checked() {
  clear(GlPass::colour);
  std::uint64_t sum = 0;
  std::vector<const Item*> unseen;
  const auto with_its_own = [](const Surface& surface) -> const Part& {
    return surface.parts[static_cast<std::size_t>(GlPass::colour)];
  };
  for (const Item& item : items_) {
    const std::uint64_t passed = samples_passed(gl_, [&] { draw_item(item, GlPass::colour); });
    const Part& part = with_its_own(item.surfaces.front()); // all have the same shaders, where they have their own
    if (const GLenum error = take_error(gl_); error != GL_NO_ERROR)
      refuse(gl_, item.name, part.program->name, part.program->vertex, part.program->fragment, error);
    sum += passed;
    if (passed == 0 && part.program->has_position) unseen.push_back(&item);
  }
  // Hidden by others or out of view is nobody's fault. It is its shaders', if with ours it is seen and with them not,
  // alone.
  bool explained = false;
  for (const Item* const item : unseen) {
    if (!item->has_shaders_of_its_own) continue;
    const std::uint64_t with_ours =
        samples_alone(*item, [](const Surface& surface) -> const Part& { return surface.plain; });
    if (with_ours == 0 || samples_alone(*item, with_its_own) > 0) continue;
    warnings_.add(item->name, "its shaders draw nothing: no sample of it passes the depth test, where with ours " +
                                  std::to_string(with_ours) + " do");
    explained = true;
  }
  if (sum == 0 && !explained && !unseen.empty())
    warnings_.add("nothing is drawn: no sample of any object passes the depth test, with our shaders neither; all are "
                  "out of view or face away");
  if (!unseen.empty()) draw(GlPass::colour); // again, over what the question has left
  throw_if_error(gl_, "drawing");
  return sum;
}

} // namespace refraster
