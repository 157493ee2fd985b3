#pragma once
// What odd shaders have in common.

#include "tests/system/gl/odd_shaders.h"

namespace refraster::odd {

inline constexpr std::array<float, 3> background{0.25f, 0.5f, 0.75f}, white{1, 1, 1}, black{0, 0, 0};

inline const std::string not_set = " is not one that refraster sets: ", stays_0 = not_set + "it stays 0",
                         reads_black = not_set + "it reads (0, 0, 0, 1)", constant = "it stays (0, 0, 0, 1)";
inline const std::string nothing_drawn =
    "ball: its shaders draw nothing: no sample of it passes the depth test, where with "
    "ours N do";
inline const std::string no_colour =
    "ball: the fragment shader writes no colour: it has no output at location 0 that it writes to";

/// A fragment shader that takes what our vertex shader gives.
inline std::string fragment(const std::string& body, const std::string& declarations = {}, int version = 330) {
  return "#version " + std::to_string(version) +
         " core\nin VS_OUT { vec3 FragPos; vec3 Normal; vec2 TexCoord; } fs_in;\nout vec4 FragColor;\n" + declarations +
         "\nvoid main() { " + body + " }\n";
}

/// One that declares its own output, and takes nothing.
inline std::string bare(const std::string& declarations, const std::string& body, int version = 330) {
  return "#version " + std::to_string(version) + " core\n" + declarations + "\nvoid main() { " + body + " }\n";
}

inline const std::string white_fragment = bare("out vec4 FragColor;", "FragColor = vec4(1.0);");
inline const std::string usual_position = "gl_Position = clipFromObject * vec4(vPos, 1.0);";
inline const std::string usual_declarations = "layout(location = 0) in vec3 vPos; uniform mat4 clipFromObject;\n";

inline std::string with_matrices(const std::string& block, const std::string& position = "projection * view") {
  return bare("layout(location = 0) in vec3 vPos; uniform mat4 model;\n" + block,
              "gl_Position = " + position + " * model * vec4(vPos, 1.0);");
}
inline std::string wrong_matrices(const std::string& found) {
  return "ball: uniform block Matrices: found " + found +
         "; expected layout (std140) with mat4 view at byte 0 and mat4 projection at byte 64, column_major: its "
         "matrices are wrong";
}

void add_samplers(std::vector<OddShader>& list);
void add_uniforms(std::vector<OddShader>& list);

} // namespace refraster::odd
