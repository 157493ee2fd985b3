#pragma once
// Meshes, textures and tables become GL objects.

#include <refraster/scene.h>

#include "gl/context/gl_api.h"

namespace refraster {

/// A vertex array with the attributes that the mesh has, each at its place in vertex_attributes, and its indices. Of
/// them those whose bit is set in `attributes`.
GLuint upload_mesh(const GlApi& gl, const Mesh& mesh, unsigned attributes);

/// In RGB8 or RGB16, whichever holds the image's values exactly, with the mip levels that it has, rounded to that
/// format; or, of another full scale, in RGB32F, which holds decoded values as they are. Throws NoOpenGl for one that
/// is larger than this OpenGL's. Its scale and offset are the shader's affair.
GLuint upload_texture(const GlApi& gl, const TextureMap& map);

/// One texel of this colour: what a shader samples of an object without a texture.
GLuint upload_blank(const GlApi& gl, const Double3& colour);

enum class TableContent { values, logarithms };

/// A 3D texture of RGBA32F: phi_d along s, theta_d along t, theta_h along r, so that a shader reads
/// texture(merlBrdf, vec3(z, y, x)) with x, y, z the coordinates of theta_h, theta_d, phi_d in [0, 1]. Repeats along s,
/// is clamped along t and r. Alpha is 1, and all four are 0 where nothing was measured: a filtered value divided by its
/// alpha is the weighted mean of what was measured.
GLuint upload_table(const GlApi& gl, const MerlTable& table, TableContent content, MerlLookup lookup);

} // namespace refraster
