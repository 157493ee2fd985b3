#include "verify/gl/shader_choice.h"

#include "io/input_file.h"
#include "verify/gl/own_glsl.h"

#include <filesystem>

namespace refraster {
namespace {

constexpr std::uint64_t largest_shader_bytes = 1 << 20; // a shader is text that someone wrote

/// A stage's text, and in words where it is from.
std::pair<ShaderText, std::string> choose(const std::string& path, std::string own_text, const std::string& own_name) {
  std::error_code ignored;
  if (path.empty()) return {{own_name, std::move(own_text)}, "ours (the scene names none)"};
  if (!std::filesystem::exists(path, ignored))
    return {{own_name, std::move(own_text)}, "ours (there is no " + path + ")"};
  return {{path, read_file(path, "a GLSL file", largest_shader_bytes)}, path};
}

} // namespace

ShaderChoice choose_shaders(const Scene& scene, const Object& object, MerlFilter filter) {
  const std::string_view model = std::visit([](const auto& m) { return m.name; }, object.material.model);
  const auto [vertex, vertex_from] =
      choose(object.vertex_shader_path, own_vertex_glsl(GlslDialect::core_330), "our vertex shader");
  const auto [fragment, fragment_from] =
      choose(object.fragment_shader_path, own_fragment_glsl(scene, object.material, filter, GlslDialect::core_330),
             "our fragment shader of " + std::string(model));
  return {vertex, fragment,
          object.name + ": vertex shader " + vertex_from + ", fragment shader of " + std::string(model) + " " +
              fragment_from};
}

} // namespace refraster
