#pragma once
// Our GLSL of the formulas in shading/: used where a scene names none.

#include <refraster/scene.h>

#include "gl/gl_names.h"

#include <string>
#include <string_view>
#include <vector>

namespace refraster {

/// The parts in gl/glsl, one string a file.
struct GlslText {
  std::string_view vertex, surface, shadow, normal_map, colours, phong, merl, microfacet, opacity, main, ids;
};
extern const GlslText glsl_text;

/// OpenGL 3.3, and WebGL 2.
enum class GlslDialect { core_330, es_300 };

/// For one object's mesh: attributes that the lecture's shaders do not know are handed over where the mesh has them.
std::string own_vertex_glsl(const Mesh& mesh, GlslDialect dialect);

/// Whether there is GLSL of ours for this fragment function.
bool has_own_glsl(const Material& material);

/// Whether our GLSL sums lights of this type.
bool has_own_glsl(const LightNames& lights);

/// Whether our GLSL reads this texture, where the fragment function shows any.
bool has_own_glsl(const TextureSlot& slot);

/// Whether our fragment shaders read this varying of a vertex attribute.
bool has_own_glsl(std::string_view varying);

/// What our GLSL would leave out of an object's image: "point lights", "texture_file_path", "texture coordinates".
std::vector<std::string_view> without_glsl(const Scene& scene, const Object& object);

/// For one object's mesh and material under the scene's lights: how many lights there are, whether there is a texture
/// or are colours, how a table is read, whether normals are turned, is compiled in, so that no pixel pays for what the
/// scene does not use.
std::string own_fragment_glsl(const Scene& scene, const Mesh& mesh, const Material& material, TwoSided two_sided,
                              MerlFilter filter, GlslDialect dialect);

/// A fragment shader that writes which object and triangle is seen, for one object's mesh and material: the same samples
/// as own_fragment_glsl's.
std::string own_ids_glsl(const Mesh& mesh, const Material& material);

/// Whether our GLSL reads the table as logarithms (MerlTable::log_values).
bool reads_logarithms(MerlLookup lookup);

} // namespace refraster
