#include "io/mesh/mesh_normals.h"

#include <array>
#include <charconv>

namespace refraster {

std::string name_of(const MeshNormals& normals) {
  if (normals.from != NormalsFrom::crease) return std::string(name_of(normals.from));
  std::array<char, 32> text;
  return "crease-" +
         std::string(text.data(), std::to_chars(text.data(), text.data() + text.size(), normals.crease_degrees).ptr);
}

std::string name_of(const ObjOptions& options) {
  const std::string normals = name_of(options.normals);
  return options.colours == VertexColours::linear ? normals : normals + "." + std::string(name_of(options.colours));
}

} // namespace refraster
