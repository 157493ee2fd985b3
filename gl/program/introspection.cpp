#include "gl/program/introspection.h"

#include "gl/context/gl_errors.h"

#include <algorithm>

namespace refraster {
namespace {

GLint program_value(const GlApi& gl, GLuint program, GLenum name) {
  GLint value = 0;
  gl.GetProgramiv(program, name, &value);
  return value;
}

/// The text that `get` copies into a place of that many characters, and counts.
template <class Get>
std::string text_of(GLint room, Get&& get) {
  std::string text(static_cast<std::size_t>(std::max(room, 1)), '\0');
  GLsizei length = 0;
  get(static_cast<GLsizei>(text.size()), &length, text.data());
  text.resize(static_cast<std::size_t>(length));
  return text;
}

GLint uniform_value(const GlApi& gl, GLuint program, GLuint index, GLenum name) {
  GLint value = 0;
  gl.GetActiveUniformsiv(program, 1, &index, name, &value);
  return value;
}

/// Those that have a location. get(i, room, length, variable, text) asks for one, location(name) where it is.
template <class Get, class Location>
std::vector<ProgramVariable> variables_with_location(GLint count, GLint longest, const Get& get,
                                                     const Location& location) {
  std::vector<ProgramVariable> variables;
  for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
    ProgramVariable variable;
    variable.name =
        text_of(longest, [&](GLsizei room, GLsizei* length, GLchar* text) { get(i, room, length, variable, text); });
    variable.location = location(variable.name.c_str());
    if (variable.location >= 0) variables.push_back(variable);
  }
  return variables;
}

} // namespace

std::vector<ProgramVariable> active_uniforms(const GlApi& gl, GLuint program) {
  return variables_with_location(
      program_value(gl, program, GL_ACTIVE_UNIFORMS), program_value(gl, program, GL_ACTIVE_UNIFORM_MAX_LENGTH),
      [&](GLuint i, GLsizei room, GLsizei* length, ProgramVariable& uniform, GLchar* text) {
        gl.GetActiveUniform(program, i, room, length, &uniform.size, &uniform.type, text);
      },
      [&](const GLchar* name) { return gl.GetUniformLocation(program, name); }); // others are built in, or in a block
}

std::vector<ProgramVariable> active_attributes(const GlApi& gl, GLuint program) {
  return variables_with_location(
      program_value(gl, program, GL_ACTIVE_ATTRIBUTES), program_value(gl, program, GL_ACTIVE_ATTRIBUTE_MAX_LENGTH),
      [&](GLuint i, GLsizei room, GLsizei* length, ProgramVariable& attribute, GLchar* text) {
        gl.GetActiveAttrib(program, i, room, length, &attribute.size, &attribute.type, text);
      },
      [&](const GLchar* name) { return gl.GetAttribLocation(program, name); }); // others are built in: gl_VertexID
}

std::vector<UniformBlock> active_blocks(const GlApi& gl, GLuint program) {
  std::vector<UniformBlock> blocks(static_cast<std::size_t>(program_value(gl, program, GL_ACTIVE_UNIFORM_BLOCKS)));
  for (GLuint i = 0; i < blocks.size(); ++i) {
    UniformBlock& block = blocks[i];
    block.index = i;
    GLint longest = 0;
    gl.GetActiveUniformBlockiv(program, i, GL_UNIFORM_BLOCK_NAME_LENGTH, &longest);
    gl.GetActiveUniformBlockiv(program, i, GL_UNIFORM_BLOCK_DATA_SIZE, &block.size_bytes);
    block.name = text_of(longest, [&](GLsizei room, GLsizei* length, GLchar* text) {
      gl.GetActiveUniformBlockName(program, i, room, length, text);
    });
  }
  const GLint count = program_value(gl, program, GL_ACTIVE_UNIFORMS),
              longest = program_value(gl, program, GL_ACTIVE_UNIFORM_MAX_LENGTH);
  for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
    const auto block = static_cast<std::size_t>(uniform_value(gl, program, i, GL_UNIFORM_BLOCK_INDEX));
    if (block >= blocks.size()) continue; // -1: in none
    BlockMember member;
    member.name = text_of(longest, [&](GLsizei room, GLsizei* length, GLchar* text) {
      gl.GetActiveUniform(program, i, room, length, &member.size, &member.type, text);
    });
    if (member.name.starts_with(blocks[block].name + ".")) member.name.erase(0, blocks[block].name.size() + 1);
    member.offset_bytes = uniform_value(gl, program, i, GL_UNIFORM_OFFSET);
    member.matrix_stride_bytes = uniform_value(gl, program, i, GL_UNIFORM_MATRIX_STRIDE);
    member.is_row_major = uniform_value(gl, program, i, GL_UNIFORM_IS_ROW_MAJOR);
    blocks[block].members.push_back(member);
  }
  for (UniformBlock& block : blocks)
    std::sort(block.members.begin(), block.members.end(),
              [](const BlockMember& a, const BlockMember& b) { return a.offset_bytes < b.offset_bytes; });
  return blocks;
}

std::vector<ProgramResource> resources(const GlApi& gl, GLuint program, GLenum interface,
                                       std::initializer_list<GLenum> properties) {
  if (!gl.GetProgramInterfaceiv || !gl.GetProgramResourceName || !gl.GetProgramResourceiv) return {};
  GLint count = 0, longest = 0;
  gl.GetProgramInterfaceiv(program, interface, GL_ACTIVE_RESOURCES, &count);
  // Buffers of atomic counters have no names.
  if (interface != GL_ATOMIC_COUNTER_BUFFER) gl.GetProgramInterfaceiv(program, interface, GL_MAX_NAME_LENGTH, &longest);
  if (take_error(gl) != GL_NO_ERROR) return {}; // the driver knows no such interface
  // A property may be a list; Mesa writes all of it, whatever room it is told of.
  GLint longest_list = 0;
  if (std::find(properties.begin(), properties.end(), GL_COMPATIBLE_SUBROUTINES) != properties.end())
    gl.GetProgramInterfaceiv(program, interface, GL_MAX_NUM_COMPATIBLE_SUBROUTINES, &longest_list);
  std::vector<ProgramResource> found(static_cast<std::size_t>(count));
  for (GLuint i = 0; i < found.size(); ++i) {
    if (longest > 0)
      found[i].name = text_of(longest, [&](GLsizei room, GLsizei* length, GLchar* text) {
        gl.GetProgramResourceName(program, interface, i, room, length, text);
      });
    found[i].values.resize(properties.size() + static_cast<std::size_t>(longest_list));
    if (properties.size() > 0)
      gl.GetProgramResourceiv(program, interface, i, static_cast<GLsizei>(properties.size()), properties.begin(),
                              static_cast<GLsizei>(found[i].values.size()), nullptr, found[i].values.data());
  }
  return take_error(gl) == GL_NO_ERROR ? found : std::vector<ProgramResource>{};
}

} // namespace refraster
