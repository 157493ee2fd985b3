#pragma once
// A scene, uploaded and ready to be drawn as often as one likes.

#include "gl/draw/dummy_textures.h"
#include "gl/draw/shadow_maps.h"
#include "gl/draw/uniforms.h"
#include "gl/program/program_use.h"
#include "gl/render_gl.h"
#include "gl/warning_list.h"

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace refraster {

/// What a pass writes to the colour target.
enum class GlPass {
  colour,
  ids // object and triangle, counted from 1, in red and green
};

/// Needs its context to live and be current.
class GlDrawing {
public:
  /// Compiles, links and uploads. Throws InputError; NoOpenGl for what is too much for this OpenGL.
  GlDrawing(const GlApi& gl, const Scene& scene, const GlOptions& options);

  /// Clears the current framebuffer and draws all objects, in the order of the scene.
  void draw(GlPass pass) const;

  /// The same in colour, with an eye on what may go wrong, object by object: a warning for one of which nothing is seen
  /// for no other reason than its own shaders. The samples that pass the depth test, of all. Throws InputError for
  /// shaders that OpenGL refuses to draw with.
  std::uint64_t draw_checked();

  const std::vector<std::string>& shaders() const { return shaders_; }
  std::vector<std::string> warnings() const { return warnings_.lines(); }

private:
  /// In the order of texture_slots.
  using SlotTextures = std::array<GLuint, texture_slots.size()>;
  /// Triangles that follow one another, have one material and show the same textures: blank ones on those without
  /// texture coordinates.
  struct Run {
    std::size_t surface = 0; // in Item::surfaces
    SlotTextures textures{};
    std::size_t first_triangle = 0, triangles = 0;
  };

  struct Program {
    ShaderText vertex, fragment;
    std::size_t function = 0; // the fragment function's place in FragmentFunction: what is set depends on it
    GLuint name = 0;
    AttributeUse attributes;
    ColourMask mask{GL_TRUE, GL_TRUE, GL_TRUE};
    std::vector<StorageUse> storage;
    SubroutineUse subroutines;
    bool has_position = true; // else where it draws is undefined, and nothing is drawn
  };
  struct Part { // of an item, for one pass
    const Program* program = nullptr;
    GLuint vertices = 0;
    std::vector<UniformSetting> uniforms;
  };
  struct Surface { // what triangles of one material are drawn with
    SlotTextures textures{};
    GLuint table = 0;
    GLint triangle_number = -1; // place of that uniform in the program of ids
    Part parts[2];              // by pass
    Part plain;                 // with our shaders, for those that have shaders of their own
  };
  struct Item {
    std::string name;
    Cull cull = Cull::none;
    std::vector<std::pair<GLuint, float>> missing; // attributes that the mesh has none of, and what stands for them
    bool has_shaders_of_its_own = false;
    std::vector<Surface> surfaces; // one or more
    std::vector<Run> runs;         // in the order of the mesh: of equal depths the first is seen
  };

  Item item(const Scene& scene, std::size_t object, const GlOptions& options, const Double4x4& clip_from_world);
  Surface surface(const Scene& scene, const Object& object, std::size_t number, const GlOptions& options,
                  const Double4x4& clip_from_world, Item& item);
  void add_runs(const Mesh& mesh, std::size_t surface, std::size_t begin, std::size_t end, Item& item) const;
  Part part(const Object& object, const ShaderText& vertex, const ShaderText& fragment, const UniformValues& values,
            WarningList& warnings);
  const Program& linked(const ShaderText& vertex, const ShaderText& fragment, const Object& object,
                        WarningList& warnings);
  void upload_blocks(const MatricesBlock& matrices);
  void clear(GlPass pass) const;
  void prepare(const Item& item, const Surface& surface, const Part& part) const;
  void draw_item(const Item& item, GlPass pass) const;
  void bind_textures(const SlotTextures& textures) const;
  /// With part_of(surface) of each run's surface; draw_run(surface, run) draws it.
  template <class PartOf, class DrawRun>
  void draw_runs(const Item& item, const PartOf& part_of, const DrawRun& draw_run) const;
  void draw_run(const Run& run) const;
  void draw_each(const Surface& surface, const Run& run) const;
  template <class PartOf>
  std::uint64_t samples_alone(const Item& item, const PartOf& part_of) const;

  const GlApi& gl_;
  Double3 background_;
  std::vector<LightView> shadow_views_; // of the lights with maps
  std::vector<Item> items_;
  SlotTextures blank_{}; // what stands for each
  std::vector<std::string> shaders_;
  WarningList warnings_;
  DummyTextures dummies_;
  GLint largest_block_bytes_ = 0;
  // What several objects share.
  std::map<std::pair<const Mesh*, unsigned>, GLuint> meshes_; // by the attributes that are fed, too
  std::map<std::tuple<const Texture*, TextureFilter, TextureWrap>, GLuint> textures_;
  std::map<std::pair<const MerlTable*, MerlLookup>, GLuint> tables_;
  std::deque<Program> programs_;
  std::map<std::tuple<GLenum, GLuint, GLint>, GLuint> storage_; // buffers, by target, binding and size
};

} // namespace refraster
