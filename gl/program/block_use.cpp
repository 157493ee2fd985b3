#include "gl/draw/uniforms.h"
#include "gl/program/introspection.h"
#include "gl/program/program_use.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace refraster {
namespace {

struct MatrixMember {
  const char* name;
  GLint offset_bytes;
};
constexpr MatrixMember of_matrices[] = {{"view", offsetof(MatricesBlock, view)},
                                        {"projection", offsetof(MatricesBlock, projection)}};
constexpr GLint column_bytes = sizeof(glm::vec4); // std140

/// What is not as it should be of a member that should be at `expected`; empty if it is.
std::string fault_of(const BlockMember& member, const MatrixMember& expected) {
  if (member.type != GL_FLOAT_MAT4) return array_type_name(member.name, member.type, member.size) + " " + member.name;
  std::string fault;
  if (member.offset_bytes != expected.offset_bytes) fault += " at byte " + std::to_string(member.offset_bytes);
  if (member.is_row_major) fault += " row_major";
  else if (member.matrix_stride_bytes != column_bytes)
    fault += " with " + std::to_string(member.matrix_stride_bytes) + " bytes a column";
  return fault.empty() ? "" : member.name + fault;
}

void check_matrices(const UniformBlock& block, std::vector<std::string>& warnings) {
  std::string faults;
  for (const BlockMember& member : block.members) {
    const auto expected = std::find_if(std::begin(of_matrices), std::end(of_matrices),
                                       [&](const MatrixMember& m) { return member.name == m.name; });
    if (expected == std::end(of_matrices)) {
      warnings.push_back(
          "uniform block Matrices: " + declaration(member.name, member.type, member.size) + " at byte " +
          std::to_string(member.offset_bytes) + " is not one that refraster sets: it is " +
          (member.offset_bytes < static_cast<GLint>(sizeof(MatricesBlock)) ? "a part of the matrices" : "0"));
    } else if (const std::string fault = fault_of(member, *expected); !fault.empty()) {
      faults += (faults.empty() ? "" : ", ") + fault;
    }
  }
  if (!faults.empty())
    warnings.push_back("uniform block Matrices: found " + faults +
                       "; expected layout (std140) with mat4 view at byte 0 and mat4 projection at byte 64, "
                       "column_major: its matrices are wrong");
}

} // namespace

GLint bind_blocks(const GlApi& gl, GLuint program, std::vector<std::string>& warnings) {
  GLint largest = 0;
  std::map<std::string, int> unknown; // by name without index: how many elements of an array of blocks
  const std::vector<UniformBlock> blocks = active_blocks(gl, program);
  const auto base_name = [](const UniformBlock& block) { return block.name.substr(0, block.name.find('[')); };
  for (const UniformBlock& block : blocks)
    if (block.name != "Matrices") ++unknown[base_name(block)];
  for (const UniformBlock& block : blocks) {
    largest = std::max(largest, block.size_bytes);
    if (block.name == "Matrices") {
      check_matrices(block, warnings);
      gl.UniformBlockBinding(program, block.index, matrices_binding);
      continue;
    }
    const bool has_matrices = std::any_of(block.members.begin(), block.members.end(), [](const BlockMember& member) {
      return std::any_of(std::begin(of_matrices), std::end(of_matrices),
                         [&](const MatrixMember& m) { return member.name == m.name; });
    });
    gl.UniformBlockBinding(program, block.index, zeros_binding);
    const int elements = std::exchange(unknown[base_name(block)], 0);
    if (elements == 0) continue; // said of the first
    warnings.push_back("uniform block " + block.name +
                       (elements > 1 ? " (and " + std::to_string(elements - 1) + " more elements)" : "") +
                       " is not one that refraster sets: all of it is 0" +
                       (has_matrices ? "; view and projection are in a block named Matrices" : ""));
  }
  return largest;
}

std::vector<StorageUse> storage_use(const GlApi& gl, GLuint program, std::vector<std::string>& warnings) {
  // An array without a size counts as one element; shaders that index it find zeros in as much as this.
  constexpr GLint min_bytes = 1 << 16;
  std::vector<StorageUse> uses;
  const auto add = [&](GLenum interface, GLenum target) {
    for (const ProgramResource& buffer : resources(gl, program, interface, {GL_BUFFER_BINDING, GL_BUFFER_DATA_SIZE})) {
      uses.push_back({target, static_cast<GLuint>(buffer.values[0]), std::max(buffer.values[1], min_bytes)});
      warnings.push_back((buffer.name.empty()
                              ? "nobody sets the atomic counters at binding " + std::to_string(buffer.values[0])
                              : "buffer " + buffer.name + " is not one that refraster sets") +
                         ": all of it is 0 before each draw, and what is written to it is lost");
    }
  };
  add(GL_SHADER_STORAGE_BLOCK, GL_SHADER_STORAGE_BUFFER);
  add(GL_ATOMIC_COUNTER_BUFFER, GL_ATOMIC_COUNTER_BUFFER);
  return uses;
}

} // namespace refraster
