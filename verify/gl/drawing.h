#pragma once
// A scene, uploaded and ready to be drawn as often as one likes.

#include "verify/gl/program.h"
#include "verify/gl/render_gl.h"
#include "verify/gl/uniforms.h"

#include <map>
#include <tuple>

namespace refraster {

/// What a pass writes to the colour target.
enum class GlPass {
  colour,
  ids // object and triangle, counted from 1, in red and green
};

/// Needs its context to live and be current.
class GlDrawing {
public:
  /// Compiles, links and uploads. Throws InputError.
  GlDrawing(const GlApi& gl, const Scene& scene, const GlOptions& options);

  /// Clears the current framebuffer and draws all objects, in the order of the scene.
  void draw(GlPass pass) const;

  const std::vector<std::string>& shaders() const { return shaders_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

private:
  /// Triangles that follow one another and show one texture: white on those without texture coordinates.
  struct TextureRun {
    GLuint texture = 0;
    std::size_t first_triangle = 0, triangles = 0;
  };
  static std::vector<TextureRun> texture_runs(const Mesh& mesh, GLuint texture, GLuint white);

  struct Item {
    GLuint vertices = 0, table = 0;
    std::vector<TextureRun> runs;
    Cull cull = Cull::none;
    GLint triangle_number = -1;              // place of that uniform in the program of ids
    GLuint program[2] = {};                  // by pass
    std::vector<UniformSetting> uniforms[2]; // by pass
  };

  Item item(const Scene& scene, std::size_t object, const GlOptions& options, const Double4x4& clip_from_world);
  void draw_each(const Item& item, const TextureRun& run) const;
  GLuint linked(const ShaderText& vertex, const ShaderText& fragment, const std::string& object);

  const GlApi& gl_;
  Double3 background_;
  std::vector<Item> items_;
  GLuint white_ = 0;
  std::vector<std::string> shaders_, warnings_;
  // What several objects share.
  std::map<const Mesh*, GLuint> meshes_;
  std::map<std::pair<const Texture*, TextureFilter>, GLuint> textures_;
  std::map<std::pair<const MerlTable*, MerlLookup>, GLuint> tables_;
  std::vector<std::tuple<ShaderText, ShaderText, GLuint>> programs_;
};

} // namespace refraster
