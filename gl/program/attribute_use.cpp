#include "gl/program/introspection.h"
#include "gl/program/program_use.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

namespace refraster {
namespace {

struct MeshAttribute {
  std::string_view name;
  int components;
  std::string_view what;
  std::string type() const { return "vec" + std::to_string(components); }
};
/// By location.
constexpr std::array of_mesh = std::apply(
    [](const auto&... each) {
      return std::array{MeshAttribute{each.input, each.components, each.words}...};
    },
    vertex_attributes);
constexpr const char* stays = "it stays (0, 0, 0, 1)";

} // namespace

AttributeUse attribute_use(const GlApi& gl, const GlProgram& program, std::vector<std::string>& warnings) {
  AttributeUse use;
  for (const ProgramVariable& attribute : active_attributes(gl, program.name)) {
    const GlslType& type = glsl_type(attribute.type);
    const auto own = std::find_if(std::begin(of_mesh), std::end(of_mesh),
                                  [&](const MeshAttribute& m) { return attribute.name == m.name; });
    const auto first = static_cast<unsigned>(attribute.location);
    const auto end = first + static_cast<unsigned>(attribute.size * type.columns);
    // No attribute of a mesh is a matrix, nor several of them an array.
    const bool fed = end == first + 1 && first < std::size(of_mesh) && type.base == GlslBase::float_;
    for (unsigned location = first; location < end; ++location)
      if (!fed || location >= std::size(of_mesh)) {
        if (location < std::size(of_mesh)) use.arrays &= ~(1u << location);
        use.constants.push_back({location, type.base});
      }

    const std::string what = declaration(attribute.name, attribute.type, attribute.size);
    const std::string place = std::to_string(first);
    if (own != std::end(of_mesh) && first != static_cast<unsigned>(own - std::begin(of_mesh)))
      warnings.push_back("attribute " + what + " is at location " + place + ", expected " +
                         std::to_string(own - std::begin(of_mesh)) + ": " +
                         (fed ? "it gets " + std::string(of_mesh[first].what) : stays));
    else if (own != std::end(of_mesh) && !fed)
      warnings.push_back("attribute " + attribute.name + ": found " + type.name + ", expected " + own->type() + ": " +
                         stays);
    else if (own == std::end(of_mesh) && first < std::size(of_mesh) && !fed)
      warnings.push_back("attribute " + what + " is at location " + place + ", where " + of_mesh[first].type() + " " +
                         std::string(of_mesh[first].name) + " is expected: " + stays);
    else if (own == std::end(of_mesh) &&
             std::count(program.moved_attributes.begin(), program.moved_attributes.end(), attribute.name) > 0)
      warnings.push_back("attribute " + what +
                         " has neither a name that refraster knows nor a location in the shader: " + stays);
    else if (own == std::end(of_mesh) && !fed)
      warnings.push_back("attribute " + what + " is not one that refraster sets: " + stays);
  }
  return use;
}

} // namespace refraster
