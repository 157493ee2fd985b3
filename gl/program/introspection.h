#pragma once
// What a linked program declares, as OpenGL tells it.

#include "gl/context/gl_api.h"

#include <initializer_list>
#include <string>
#include <vector>

namespace refraster {

/// Of an array of numbers or samplers OpenGL tells one variable: the first element's name, "a[0]", and the size. Of
/// arrays of structs it tells each member of each element.
struct ProgramVariable {
  std::string name;
  GLenum type = GL_NONE;
  GLint size = 1, location = -1;
};

/// Those outside of blocks that have a location: atomic counters have none.
std::vector<ProgramVariable> active_uniforms(const GlApi& gl, GLuint program);

/// Attributes of the vertex shader, without those that are built in.
std::vector<ProgramVariable> active_attributes(const GlApi& gl, GLuint program);

struct BlockMember {
  std::string name; // without the block's
  GLenum type = GL_NONE;
  GLint size = 1, offset_bytes = 0, matrix_stride_bytes = 0, is_row_major = 0;
};

struct UniformBlock {
  std::string name;
  GLuint index = 0;
  GLint size_bytes = 0;
  std::vector<BlockMember> members; // by rising offset
};
std::vector<UniformBlock> active_blocks(const GlApi& gl, GLuint program);

/// An entry of one of a program's interfaces: values of the properties asked for, in their order.
struct ProgramResource {
  std::string name;          // "" for interfaces without names
  std::vector<GLint> values; // of a list the first one, where it is asked for last
};

/// Nothing on a driver that cannot be asked (neither OpenGL 4.3 nor ARB_program_interface_query), or that has no such
/// interface. Takes OpenGL's errors.
std::vector<ProgramResource> resources(const GlApi& gl, GLuint program, GLenum interface,
                                       std::initializer_list<GLenum> properties);

} // namespace refraster
