// Odd uniforms: samplers of every type, images, numbers of every type.

#include "tests/system/gl/odd_shader_text.h"

#include <map>

namespace refraster::odd {

void add_samplers(std::vector<OddShader>& list) {
  // How each is read, with what it should give taken off: white is left.
  const std::map<std::string, std::string> reads = {
      {"1D", "texture(s, 0.5)"},
      {"2D", "texture(s, vec2(0.5))"},
      {"3D", "texture(s, vec3(0.5))"},
      {"Cube", "texture(s, vec3(0.5))"},
      {"2DRect", "texture(s, vec2(0.5))"},
      {"1DArray", "texture(s, vec2(0.5))"},
      {"2DArray", "texture(s, vec3(0.5))"},
      {"CubeArray", "texture(s, vec4(0.5))"},
      {"Buffer", "texelFetch(s, 0)"},
      {"2DMS", "texelFetch(s, ivec2(0), 0)"},
      {"2DMSArray", "texelFetch(s, ivec3(0), 0)"},
  };
  for (const auto& [shape, read] : reads)
    for (const std::string prefix : {"", "i", "u"}) {
      const std::string type = prefix + "sampler" + shape;
      list.push_back(
          {type + " beside tex",
           "",
           fragment("FragColor = texture(tex, fs_in.TexCoord) - (vec4(" + read + ") - vec4(0.0, 0.0, 0.0, 1.0));",
                    "uniform sampler2D tex; uniform " + type + " s;", shape == "CubeArray" ? 400 : 330),
           {"ball: uniform " + type + " s" + reads_black},
           white});
    }
  const std::map<std::string, std::string> shadows = {
      {"1D", "texture(s, vec3(0.5))"},
      {"2D", "texture(s, vec3(0.5))"},
      {"Cube", "texture(s, vec4(0.5))"},
      {"2DRect", "texture(s, vec3(0.5))"},
      {"1DArray", "texture(s, vec3(0.5))"},
      {"2DArray", "texture(s, vec4(0.5))"},
      {"CubeArray", "texture(s, vec4(0.5), 0.5)"},
  };
  for (const auto& [shape, read] : shadows) {
    const std::string type = "sampler" + shape + "Shadow";
    list.push_back({type + " beside tex",
                    "",
                    fragment("FragColor = texture(tex, fs_in.TexCoord) * " + read + ";",
                             "uniform sampler2D tex; uniform " + type + " s;", shape == "CubeArray" ? 400 : 330),
                    {"ball: uniform " + type + " s" + not_set + "it compares with depth 1"},
                    white});
  }
  list.push_back({"an array of samplers",
                  "",
                  fragment("FragColor = vec4(texture(maps[0], vec2(0.5)).a, texture(maps[1], vec2(0.5)).r, "
                           "texture(maps[2], vec2(0.5)).a, 1.0);",
                           "uniform sampler2D maps[3]; uniform samplerCube sky;"),
                  {"ball: uniform sampler2D maps[3]" + reads_black},
                  {{1, 0, 1}}});
  list.push_back({"samplers in an array of structs",
                  "",
                  fragment("FragColor = texture(layers[0].map, vec2(0.5)) + texture(layers[1].map, vec2(0.5)) + "
                           "vec4(layers[1].weight);",
                           "struct Layer { sampler2D map; float weight; }; uniform Layer layers[2];"),
                  {"ball: uniform sampler2D layers[0].map (and 1 more elements)" + reads_black,
                   "ball: uniform float layers[0].weight (and 1 more elements)" + stays_0},
                  black});
  list.push_back({"samplers of several types",
                  "",
                  fragment("FragColor = texture(a, 0.5) + texture(b, vec3(0.5)) + vec4(texture(c, vec2(0.5))) + "
                           "vec4(texture(d, vec2(0.5))) + vec4(texture(e, vec3(0.5))) + texture(tex, vec2(0.5));",
                           "uniform sampler1D a; uniform samplerCube b; uniform isampler2D c; uniform sampler2D d; "
                           "uniform sampler2DShadow e; uniform sampler2D tex;"),
                  {"ball: uniform sampler1D a" + reads_black, "ball: uniform samplerCube b" + reads_black,
                   "ball: uniform isampler2D c" + reads_black, "ball: uniform sampler2D d" + reads_black,
                   "ball: uniform sampler2DShadow e" + not_set + "it compares with depth 1"},
                  {{2, 2, 2}}});
  list.push_back({"tex of another type",
                  "",
                  fragment("FragColor = texture(tex, vec3(0.5));", "uniform samplerCube tex;"),
                  {"ball: uniform tex: found samplerCube, expected sampler2D: it reads (0, 0, 0, 1)"},
                  black});
  list.push_back({"tex as an array",
                  "",
                  fragment("FragColor = texture(tex[1], vec2(0.5));", "uniform sampler2D tex[2];"),
                  {"ball: uniform tex: found sampler2D[2], expected sampler2D: it reads (0, 0, 0, 1)"},
                  black});
  list.push_back(
      {"a measured table where there is none",
       "",
       fragment("FragColor = texture(merlBrdf, vec3(0.5));", "uniform sampler3D merlBrdf;"),
       {"ball: uniform sampler3D merlBrdf is not set for the fragment function phong: it reads (0, 0, 0, 1)"},
       black});
  list.push_back(
      {"a sampler in the vertex shader",
       bare(usual_declarations + "uniform sampler1D s;", usual_position + " gl_Position.x += texture(s, 0.5).r;"),
       white_fragment,
       {"ball: uniform sampler1D s" + reads_black},
       white});
  std::string many, sum = "FragColor = vec4(0.0);";
  for (int i = 0; i < 40; ++i) {
    many += "uniform sampler2D s" + std::to_string(i) + "; ";
    sum += " FragColor += texture(s" + std::to_string(i) + ", fs_in.TexCoord);";
  }
  list.push_back({"more samplers than there are units",
                  "",
                  fragment(sum, many),
                  {},
                  {},
                  3,
                  "Too many fragment shader texture samplers"});
}

void add_uniforms(std::vector<OddShader>& list) {
  list.push_back(
      {"initial values",
       "",
       fragment("FragColor = vec4(tint * vec3(on) * strength[1], 1.0) + vec4(m[0][1]);",
                "uniform vec3 tint = vec3(1.0, 0.5, 0.25); uniform bool on = true; uniform mat3 m = mat3(1.0); "
                "uniform float strength[3] = float[3](0.0, 1.0, 2.0);"),
       {"ball: uniform vec3 tint" + not_set + "it keeps its initial value, (1, 0.5, 0.25)",
        "ball: uniform bool on" + not_set + "it keeps its initial value, 1",
        "ball: uniform mat3 m" + not_set + "it keeps its initial value",
        "ball: uniform float strength[3]" + not_set + "it keeps its initial value, (0, 1, 2)"},
       {{1, 0.5, 0.25}}});
  list.push_back({"an initial value of one of another type",
                  "",
                  fragment("FragColor = vec4(float(glossiness) / 4.0);", "uniform int glossiness = 2;"),
                  {"ball: uniform glossiness: found int, expected float: it keeps its initial value, 2"},
                  {{0.5, 0.5, 0.5}}});
  list.push_back(
      {"numbers of every base",
       "",
       fragment("FragColor = vec4(float(d) + float(i.y) + float(u.z) + float(m[1][2]) + float(dm[1][0]));",
                "uniform double d; uniform ivec2 i; uniform uvec3 u; uniform mat2x3 m; uniform dmat2 dm;", 410),
       {"ball: uniform double d" + stays_0, "ball: uniform ivec2 i" + stays_0, "ball: uniform uvec3 u" + stays_0,
        "ball: uniform mat2x3 m" + stays_0, "ball: uniform dmat2 dm" + stays_0},
       black});
  list.push_back({"an array where one value is expected",
                  "",
                  fragment("FragColor = vec4(kd[1], 1.0);", "uniform vec3 kd[2];"),
                  {"ball: uniform kd: found vec3[2], expected vec3: it stays 0"},
                  black});
  list.push_back({"members of lights that there are not",
                  "",
                  fragment("vec3 sum = vec3(0.0); for (int i = 0; i < 8; ++i) sum += directionLights[i].color; "
                           "FragColor = vec4(sum, 1.0);",
                           "struct Light { vec3 direction; vec3 color; }; uniform Light directionLights[8];"),
                  {"ball: uniform vec3 directionLights[0].color" + stays_0},
                  black});
  list.push_back({"matrices outside of their block",
                  with_matrices("uniform mat4 view, projection;"),
                  white_fragment,
                  {"ball: uniform mat4 view" + stays_0, "ball: uniform mat4 projection" + stays_0, nothing_drawn},
                  background});
  const std::map<std::string, std::string> places = {
      {"1D", "0"},
      {"2D", "ivec2(0)"},
      {"3D", "ivec3(0)"},
      {"Cube", "ivec3(0)"},
      {"2DRect", "ivec2(0)"},
      {"1DArray", "ivec2(0)"},
      {"2DArray", "ivec3(0)"},
      {"CubeArray", "ivec3(0)"},
      {"Buffer", "0"},
      {"2DMS", "ivec2(0), 0"},
      {"2DMSArray", "ivec3(0), 0"},
  };
  for (const auto& [shape, place] : places) {
    std::string declarations, sum = "vec4(0.0)";
    std::vector<std::string> warnings;
    for (const std::string prefix : {"", "i", "u"}) {
      const std::string type = prefix + "image" + shape, name = prefix + "img";
      declarations += "layout(rgba8" + (prefix == "u" ? "ui" : prefix) + ") uniform " + type + " " + name + "; ";
      sum += " + vec4(imageLoad(" + name + ", " + place + "))";
      warnings.push_back("ball: uniform " + type + " " + name + not_set +
                         "it reads 0, and what is written to it is lost");
    }
    list.push_back(
        {"images of shape " + shape, "", fragment("FragColor = " + sum + ";", declarations, 420), warnings, black});
  }
  list.push_back({"an image that is written to",
                  "",
                  fragment("FragColor = imageLoad(img, ivec2(0)); imageStore(img, ivec2(0), vec4(1.0));",
                           "layout(rgba8) uniform image2D img;", 420),
                  {"ball: uniform image2D img" + not_set + "it reads 0, and what is written to it is lost"},
                  black});
  list.push_back({"a subroutine",
                  "",
                  fragment("FragColor = shade();",
                           "subroutine vec4 Shade(); subroutine uniform Shade shade; "
                           "subroutine(Shade) vec4 white() { return vec4(1.0); } "
                           "subroutine(Shade) vec4 grey() { return vec4(0.5); }",
                           400),
                  {"ball: subroutine uniform shade" + not_set + "it calls white"},
                  white});
}

} // namespace refraster::odd
