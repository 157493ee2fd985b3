#include "tests/system/gl/odd_shader_text.h"

namespace refraster {
namespace odd {
namespace {

void add_blocks(std::vector<OddShader>& list) {
  const std::string camera = "layout(std140) uniform Camera { mat4 view; mat4 projection; };";
  list.push_back({"members of Matrices exchanged",
                  with_matrices("layout(std140) uniform Matrices { mat4 projection; mat4 view; };"),
                  white_fragment,
                  {wrong_matrices("projection at byte 0, view at byte 64"), nothing_drawn},
                  background});
  list.push_back({"Matrices row by row",
                  with_matrices("layout(std140, row_major) uniform Matrices { mat4 view; mat4 projection; };"),
                  white_fragment,
                  {wrong_matrices("view row_major, projection row_major"), nothing_drawn},
                  background});
  list.push_back({"one of two matrices row by row",
                  with_matrices("layout(std140) uniform Matrices { mat4 view; layout(row_major) mat4 projection; };",
                                "transpose(projection) * view"),
                  white_fragment,
                  {wrong_matrices("projection row_major")},
                  white});
  list.push_back({"Matrices with one missing",
                  with_matrices("layout(std140) uniform Matrices { mat4 projection; };", "0.0 * projection"),
                  white_fragment,
                  {wrong_matrices("projection at byte 0"), nothing_drawn},
                  background});
  list.push_back({"Matrices of another type",
                  with_matrices("layout(std140) uniform Matrices { mat3 view; mat4 projection; };",
                                "projection * mat4(0.0 * view)"),
                  white_fragment,
                  {wrong_matrices("mat3 view, projection at byte 48"), nothing_drawn},
                  background});
  list.push_back({"Matrices with more",
                  with_matrices("layout(std140) uniform Matrices { mat4 view; mat4 projection; "
                                "vec4 eye; };",
                                "(1.0 + eye.x) * projection * view"),
                  white_fragment,
                  {"ball: uniform block Matrices: vec4 eye at byte 128" + not_set + "it is 0"},
                  white});
  list.push_back(
      {"Matrices by an instance's name",
       with_matrices("layout(std140) uniform Matrices { mat4 view; mat4 projection; } m;", "m.projection * m.view"),
       white_fragment,
       {},
       white});
  list.push_back({"Matrices without std140",
                  with_matrices("uniform Matrices { mat4 view; mat4 projection; };"),
                  white_fragment,
                  {},
                  white});
  list.push_back(
      {"Matrices by another name",
       with_matrices(camera),
       white_fragment,
       {"ball: uniform block Camera" + not_set + "all of it is 0; view and projection are in a block named Matrices",
        nothing_drawn},
       background});
  list.push_back({"an array of blocks",
                  "",
                  fragment("FragColor = b[0].a + b[2].a;", "layout(std140) uniform B { vec4 a; } b[3];"),
                  {"ball: uniform block B[0] (and 2 more elements)" + not_set + "all of it is 0"},
                  black});
  list.push_back({"a large block",
                  "",
                  fragment("FragColor = a[999];", "layout(std140) uniform B { vec4 a[1000]; };"),
                  {"ball: uniform block B" + not_set + "all of it is 0"},
                  black});
  list.push_back({"a block that is too large",
                  "",
                  fragment("FragColor = a[999];", "layout(std140) uniform B { vec4 a[100000]; };"),
                  {},
                  {},
                  3,
                  "Uniform block B too big"});
  list.push_back(
      {"a storage buffer that is written to",
       "",
       fragment("FragColor = vec4(x[2] + x[3]); x[3] = 1.0;", "layout(std430, binding = 3) buffer Data { float x[]; };",
                430),
       {"ball: buffer Data" + not_set + "all of it is 0 before each draw, and what is written to it is lost"}});
  // Vertices come before fragments, so that what one draw writes only another one could read.
  const std::string data = "layout(std430, binding = 3) buffer Data { float x[]; };\n";
  list.push_back(
      {"a storage buffer that another draw has written to",
       bare(usual_declarations + data + "out float before;", "before = x[0]; " + usual_position, 430),
       bare(data + "in float before; out vec4 FragColor;", "FragColor = vec4(1.0 - before); x[0] = 1.0;", 430),
       {"ball: buffer Data" + not_set + "all of it is 0 before each draw, and what is written to it is lost"},
       white});
  list.push_back({"an atomic counter",
                  "",
                  fragment("FragColor = vec4(atomicCounter(n));", "layout(binding = 0) uniform atomic_uint n;", 420),
                  {"ball: nobody sets the atomic counters at binding 0: all of it is 0 before each draw, and what is "
                   "written to it is lost"},
                  black});
}

void add_attributes(std::vector<OddShader>& list) {
  list.push_back(
      {"names not ours, at locations",
       bare("layout(location = 0) in vec3 aPos; layout(location = 1) in vec3 aNormal; uniform mat4 clipFromObject; "
            "out vec3 n;",
            "n = aNormal; gl_Position = clipFromObject * vec4(aPos, 1.0);"),
       bare("in vec3 n; out vec4 FragColor;", "FragColor = vec4(length(n));"),
       {}});
  list.push_back(
      {"names not ours, without locations",
       bare("in vec3 aPos; in vec3 aNormal; uniform mat4 clipFromObject; out vec3 n;",
            "n = aNormal; gl_Position = clipFromObject * vec4(aPos, 1.0);"),
       bare("in vec3 n; out vec4 FragColor;", "FragColor = vec4(length(n));"),
       {"ball: attribute vec3 aPos has neither a name that refraster knows nor a location in the shader: " + constant,
        "ball: attribute vec3 aNormal has neither a name that refraster knows nor a location in the shader: " +
            constant,
        nothing_drawn},
       background});
  list.push_back(
      {"ours at another location",
       bare(usual_declarations + "layout(location = 2) in vec3 vNormal; out vec3 n;", "n = vNormal; " + usual_position),
       bare("in vec3 n; out vec4 FragColor;", "FragColor = vec4(n.z, 1.0, 1.0, 1.0);"),
       {"ball: attribute vec3 vNormal is at location 2, expected 1: it gets texture coordinates"},
       {{0, 1, 1}}});
  list.push_back(
      {"ours where nothing is",
       bare(usual_declarations + "layout(location = 7) in vec3 vNormal; out vec3 n;", "n = vNormal; " + usual_position),
       bare("in vec3 n; out vec4 FragColor;", "FragColor = vec4(1.0 - abs(n), 1.0);"),
       {"ball: attribute vec3 vNormal is at location 7, expected 1: " + constant},
       white});
  list.push_back({"positions as integers",
                  bare("in ivec3 vPos;", "gl_Position = vec4(vPos, 1.0);"),
                  white_fragment,
                  {"ball: attribute vPos: found ivec3, expected vec3: " + constant, nothing_drawn},
                  background});
  list.push_back({"positions in double",
                  bare("in dvec3 vPos;", "gl_Position = vec4(vPos, 1.0);", 410),
                  white_fragment,
                  {"ball: attribute vPos: found dvec3, expected vec3: " + constant, nothing_drawn},
                  background});
  list.push_back(
      {"unsigned normals by another name",
       bare(usual_declarations + "layout(location = 1) in uvec4 id; flat out uvec4 i;", "i = id; " + usual_position),
       bare("flat in uvec4 i; out vec4 FragColor;", "FragColor = vec4(1.0 - vec3(i.xyz), 1.0) * float(i.w);"),
       {"ball: attribute uvec4 id is at location 1, where vec3 vNormal is expected: " + constant},
       white});
  list.push_back({"a matrix for each instance",
                  bare(usual_declarations + "layout(location = 4) in mat4 instance; out vec4 i;",
                       "i = instance[0]; " + usual_position),
                  bare("in vec4 i; out vec4 FragColor;", "FragColor = vec4(1.0 - i.xyz, 1.0) * i.w;"),
                  {"ball: attribute mat4 instance is at location 4, where vec4 vTangent is expected: " + constant},
                  white});
  list.push_back({"positions of four components",
                  bare("in vec4 vPos; uniform mat4 clipFromObject;", "gl_Position = clipFromObject * vPos;"),
                  white_fragment,
                  {},
                  white});
  list.push_back({"no attribute at all",
                  bare("", "gl_Position = vec4(gl_VertexID % 2 * 4 - 1, gl_VertexID / 2 % 2 * 4 - 1, 0.0, 1.0);"),
                  white_fragment,
                  {},
                  white});
  list.push_back({"no position",
                  bare("in vec3 vPos; out vec3 p;", "p = vPos;"),
                  white_fragment,
                  {"ball: the vertex shader does not set gl_Position: nothing is drawn"},
                  background});
}

void add_outputs(std::vector<OddShader>& list) {
  list.push_back(
      {"an output that is not written to", "", fragment("vec3 colour = vec3(0.5);"), {no_colour}, background});
  list.push_back(
      {"an output at location 1",
       "",
       bare("layout(location = 1) out vec4 FragColor;", "FragColor = vec4(0.5);"),
       {"ball: output vec4 FragColor at location 1 goes nowhere: the image is what location 0 is given", no_colour},
       background});
  list.push_back({"two outputs",
                  "",
                  bare("layout(location = 0) out vec4 Bright; layout(location = 1) out vec4 FragColor;",
                       "FragColor = vec4(0.5); Bright = vec4(1.0);"),
                  {"ball: output vec4 FragColor at location 1 goes nowhere: the image is what location 0 is given"},
                  white});
  list.push_back({"an array of outputs",
                  "",
                  bare("out vec4 c[2];", "c[0] = vec4(1.0); c[1] = vec4(0.5);"),
                  {"ball: output vec4 c[2]: its elements from 1 on go nowhere: the image is what location 0 is given"},
                  white});
  list.push_back(
      {"a second colour for blending",
       "",
       bare("layout(location = 0, index = 0) out vec4 c; layout(location = 0, index = 1) out vec4 d;",
            "c = vec4(1.0); d = vec4(0.5);"),
       {"ball: output vec4 d at index 1 goes nowhere: it is a second colour for blending, and nothing is blended"},
       white});
  list.push_back({"an output of integers",
                  "",
                  bare("out ivec4 c;", "c = ivec4(1);"),
                  {"ball: output c: found ivec4, expected vec4: no colour is written"},
                  background});
  list.push_back({"an output of one component",
                  "",
                  bare("out float c;", "c = 1.0;"),
                  {"ball: the output at location 0 has no green and blue: nothing is written there, expected vec4"},
                  {{1, 0.5, 0.75}}});
  list.push_back({"an output of the middle components",
                  "",
                  bare("layout(location = 0, component = 1) out vec2 c;", "c = vec2(1.0);", 440),
                  {"ball: the output at location 0 has no red: nothing is written there, expected vec4"},
                  {{0.25, 1, 1}}});
  list.push_back(
      {"an output in two parts",
       "",
       bare("layout(location = 0, component = 0) out vec2 rg; layout(location = 0, component = 2) out vec2 ba;",
            "rg = vec2(1.0); ba = vec2(1.0);", 440),
       {},
       white});
  list.push_back({"an output of three components", "", bare("out vec3 c;", "c = vec3(1.0);"), {}, white});
  list.push_back({"depth only", "", bare("", "gl_FragDepth = 0.5;"), {no_colour}, background});
  list.push_back({"depth beyond what there is",
                  "",
                  fragment("FragColor = vec4(1.0); gl_FragDepth = 2.0;"),
                  {nothing_drawn},
                  background});
  list.push_back({"all discarded", "", fragment("FragColor = vec4(1.0); discard;"), {nothing_drawn}, background});
  list.push_back({"the built-in colour of older GLSL", "", bare("", "gl_FragColor = vec4(1.0);"), {}, white});
  list.push_back({"the built-in colours of older GLSL", "", bare("", "gl_FragData[0] = vec4(1.0);"), {}, white});
}

void add_text(std::vector<OddShader>& list) {
  list.push_back({"a byte order mark",
                  "\xef\xbb\xbf" + bare(usual_declarations, usual_position),
                  "\xef\xbb\xbf" + white_fragment,
                  {},
                  white});
  list.push_back(
      {"UTF-16", "", "\xff\xfe#", {}, {}, 3, "found UTF-16 text, expected a GLSL file, which is ASCII or UTF-8"});
  list.push_back({"a value that is used before it is set",
                  "",
                  fragment("vec3 a; FragColor = vec4(a.x > 0.0 ? 1.0 : 1.0);"), // `a` may be NaN
                  {"fs.glsl:5:40: the compiler warns: `a' used uninitialized"},
                  white});
  list.push_back(
      {"an input that nobody writes",
       bare(usual_declarations, usual_position),
       bare("in vec3 missing; out vec4 FragColor;", "FragColor = vec4(missing, 1.0);"),
       {"vs.glsl + fs.glsl: the linker warns: fragment shader varying missing not written by vertex shader"}});
  list.push_back({"a function without a body",
                  "",
                  fragment("FragColor = f();", "vec4 f();"),
                  {},
                  {},
                  3,
                  "our vertex shader + fs.glsl: found unresolved reference to function `f'"});
  list.push_back(
      {"NaN",
       "",
       fragment("FragColor = vec4(zero / zero);", "uniform float zero;"),
       {"ball: uniform float zero" + stays_0,
        "N pixels are NaN, the first at N,N from the top left: what 8 bits show there is the driver's choice"}});
  list.push_back(
      {"infinity",
       "",
       fragment("FragColor = vec4(1.0 / zero);", "uniform float zero;"),
       {"ball: uniform float zero" + stays_0,
        "N pixels are infinite, the first at N,N from the top left: 8 bits show the end of their range there"}});
}

} // namespace
} // namespace odd

const std::vector<OddShader>& odd_shaders() {
  static const std::vector<OddShader> all = [] {
    std::vector<OddShader> list;
    odd::add_samplers(list);
    odd::add_uniforms(list);
    odd::add_blocks(list);
    odd::add_attributes(list);
    odd::add_outputs(list);
    odd::add_text(list);
    return list;
  }();
  return all;
}

} // namespace refraster
