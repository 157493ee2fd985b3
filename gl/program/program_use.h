#pragma once
// What a program needs besides uniforms before it draws, found by asking OpenGL what the program declares.

#include <refraster/mesh.h>

#include "gl/program/glsl_types.h"
#include "gl/program/program.h"

#include <array>
#include <string>
#include <tuple>
#include <vector>

namespace refraster {

/// Places of attributes, as bits: those of vertex_attributes.
inline constexpr unsigned mesh_attributes = (1u << std::tuple_size_v<decltype(vertex_attributes)>)-1;

/// An attribute that no array feeds: it is (0, 0, 0, 1), in its own type.
struct ConstantAttribute {
  GLuint location = 0;
  GlslBase base = GlslBase::float_;
};

struct AttributeUse {
  unsigned arrays = mesh_attributes;        // those that a mesh's arrays may feed
  std::vector<ConstantAttribute> constants; // of the program's attributes, those beyond `arrays`
};

/// Warns of attributes of ours at another location, of those whose type a mesh cannot feed, and of those that nobody
/// sets. A name that is not ours is nobody's fault at location 0 to 3: there it gets what that location gets.
AttributeUse attribute_use(const GlApi& gl, const GlProgram& program, std::vector<std::string>& warnings);

/// Red, green and blue: those that the program defines, to be written; the others keep what they had. On a driver that
/// cannot be asked, all. Warns of each that is not written, and of outputs that go nowhere.
using ColourMask = std::array<GLboolean, 3>;
ColourMask colour_mask(const GlApi& gl, GLuint program, std::vector<std::string>& warnings);

/// A buffer that the program may write to, so it is filled with zeros before each draw.
struct StorageUse {
  GLenum target = GL_NONE; // GL_SHADER_STORAGE_BUFFER, GL_ATOMIC_COUNTER_BUFFER
  GLuint binding = 0;
  GLint size_bytes = 0;
};
/// Warns of each.
std::vector<StorageUse> storage_use(const GlApi& gl, GLuint program, std::vector<std::string>& warnings);

/// Where uniform blocks are bound.
inline constexpr GLuint matrices_binding = 0, zeros_binding = 1;

/// Binds the block Matrices to one place and all others to the other. Gives the size in bytes of the largest, which
/// either buffer must have: what a block reads beyond its buffer is undefined. Warns of blocks and members that nobody
/// sets, and of a Matrices that is laid out in another way.
GLint bind_blocks(const GlApi& gl, GLuint program, std::vector<std::string>& warnings);

/// Subroutines to call, by stage and location: always the first that fits. Warns of each.
struct SubroutineUse {
  std::vector<GLuint> vertex, fragment;
};
SubroutineUse subroutine_use(const GlApi& gl, GLuint program, std::vector<std::string>& warnings);

} // namespace refraster
