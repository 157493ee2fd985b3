#include "tests/support/gl/seeded_faults.h"

#include "gl/glsl/own_glsl.h"
#include "tests/support/gl/seeded_scene_faults.h"

#include <fstream>
#include <string>

namespace refraster {
namespace {

constexpr FaultyStage vertex = FaultyStage::vertex, fragment = FaultyStage::fragment;

constexpr std::string_view version = "#version 330 core\n", begin_main = "void main() {",
                           vertex_position = "gl_Position = clipFromObject * vec4(vPos, 1.0);",
                           vertex_normal = "normalMatrix * vNormal", vertex_uv = "= vTexCoord;",
                           fragment_normal = "unit(fs_in(Normal))", fragment_eye = "unit(viewPos - fs_in(FragPos))",
                           lobe = "float lobe = pow(max(cosine, 0.0), glossiness);",
                           attenuation = "1.0 / (light.constant + light.linear * d + light.quadratic * d * d)",
                           point_radiance = "light.radiance * (d > 0.0 ? attenuation : 0.0)",
                           texel = "texture(tex, TEXTURE_AT).rgb", summed = "with_lights(ambient(t), n, v, t)",
                           table_place =
                               "return vec3(phi_d * (180.0 / pi), theta_d * (180.0 / pi), 90.0 * sqrt(theta_h * "
                               "(2.0 / pi)));",
                           line_angle = "float angle = atan(abs(p.y), upper_x);",
                           measured = "vec3 f = sum.w > 0.0 ? sum.rgb / sum.w : vec3(0.0);",
                           measured_cosine = "* n_l * light.radiance : vec3(0.0)", brdf_value = "    return f;\n",
                           varyings_out = "out VS_OUT {\n    vec3 FragPos;\n    vec3 Normal;\n    vec2 TexCoord;\n}",
                           varyings_in = "in VS_OUT {\n    vec3 FragPos;\n    vec3 Normal;\n    vec2 TexCoord;\n}";

/// In the GLSL of gl/glsl. Those about highlights and textures are about Phong and Blinn-Phong, as they share it.
std::vector<SeededFault> glsl_faults() {
  return {
      // The vertex stage.
      {"normals by the model matrix", {"normals_by_model_matrix"}, {{vertex, vertex_normal, "mat3(model) * vNormal"}}},
      {"normals left in object space", {"normals_not_transformed"}, {{vertex, vertex_normal, "vNormal"}}},
      {"normals that point inward", {"normals_reversed"}, {{vertex, vertex_normal, "-(normalMatrix * vNormal)"}}},
      {"interpolated normals not normalised again",
       {"normal_normalised_at_corners"},
       {{vertex, vertex_normal, "normalize(normalMatrix * vNormal)"}, {fragment, fragment_normal, "fs_in(Normal)"}}},
      {"v turned over", {"texture_v_turned_over"}, {{vertex, vertex_uv, "= vec2(vTexCoord.x, 1.0 - vTexCoord.y);"}}},
      {"u and v exchanged", {"texture_uv_exchanged"}, {{vertex, vertex_uv, "= vTexCoord.yx;"}}},
      {"half a pixel to the left",
       {"half_pixel_left_up", "half_pixel_left_down"},
       {{vertex, vertex_position,
         "gl_Position = clipFromObject * vec4(vPos, 1.0); gl_Position.xy += gl_Position.w * vec2(-1.0 / @WIDTH@, -1.0 "
         "/ "
         "@HEIGHT@);"}}},
      {"half a pixel to the right",
       {"half_pixel_right_up", "half_pixel_right_down"},
       {{vertex, vertex_position,
         "gl_Position = clipFromObject * vec4(vPos, 1.0); gl_Position.xy += gl_Position.w * vec2(1.0 / @WIDTH@, -1.0 / "
         "@HEIGHT@);"}}},
      {"the depth test reversed",
       {"depth_reversed"},
       {{vertex, vertex_position, "gl_Position = clipFromObject * vec4(vPos, 1.0); gl_Position.z = -gl_Position.z;"}}},
      {"varyings not perspective-correct",
       {"varyings_not_perspective"},
       {{vertex, varyings_out,
         "out VS_OUT {\n noperspective vec3 FragPos;\n noperspective vec3 Normal;\n noperspective vec2 TexCoord;\n}"},
        {fragment, varyings_in,
         "in VS_OUT {\n noperspective vec3 FragPos;\n noperspective vec3 Normal;\n noperspective vec2 TexCoord;\n}"}}},
      {"normals of one corner all over the triangle",
       {},
       {{vertex, varyings_out, "out VS_OUT {\n vec3 FragPos;\n flat vec3 Normal;\n vec2 TexCoord;\n}"},
        {fragment, varyings_in, "in VS_OUT {\n vec3 FragPos;\n flat vec3 Normal;\n vec2 TexCoord;\n}"}}},
      // What a fragment starts from.
      {"varyings in half precision",
       {"half_float_varyings"},
       {{fragment, version,
         "#version 330 core\n#extension GL_ARB_shading_language_packing : enable\n"
         "vec2 half_floats(vec2 a) { return unpackHalf2x16(packHalf2x16(a)); }\n"
         "vec3 half_floats(vec3 a) { return vec3(half_floats(a.xy), half_floats(a.zz).x); }\n"},
        {fragment, "fs_in_block.name", "half_floats(fs_in_block.name)"}}},
      {"the depth test off",
       {"depth_test_off"},
       {{fragment, begin_main,
         "void main() {\n    gl_FragDepth = 1.0 - (float(@FIRST_TRIANGLE@ + gl_PrimitiveID) + 1.0) / "
         "(float(@TRIANGLES@) + "
         "2.0);"}}},
      {"front faces culled", {"culling_front"}, {{fragment, begin_main, "void main() { if (gl_FrontFacing) discard;"}}},
      {"back faces culled", {"culling_back"}, {{fragment, begin_main, "void main() { if (!gl_FrontFacing) discard;"}}},
      {"normal not normalised",
       {"normal_not_normalised", "normal_not_normalised_cofactors", "normal_normalised_at_corners"},
       {{fragment, fragment_normal, "fs_in(Normal)"}}},
      {"normals turned toward the eye",
       {"normals_turned_to_eye"},
       {{fragment, fragment_normal,
         "unit(dot(fs_in(Normal), viewPos - fs_in(FragPos)) < 0.0 ? -fs_in(Normal) : fs_in(Normal))"}}},
      {"eye direction not normalised", {"eye_not_normalised"}, {{fragment, fragment_eye, "viewPos - fs_in(FragPos)"}}},
      {"eye direction reversed", {"eye_reversed"}, {{fragment, fragment_eye, "unit(fs_in(FragPos) - viewPos)"}}},
      {"the eye taken to be at the origin", {"eye_at_origin"}, {{fragment, fragment_eye, "unit(-fs_in(FragPos))"}}},
      // Lights.
      {"point light's direction not normalised",
       {"light_not_normalised"},
       {{fragment, "Incident(way * (d > 0.0 ? 1.0 / d : 0.0)", "Incident(way"}}},
      {"direction light's direction reversed",
       {"direction_lights_reversed", "light_directions_reversed"},
       {{fragment, "Incident(-light.direction", "Incident(light.direction"}}},
      {"point light's direction reversed",
       {"point_lights_reversed", "light_directions_reversed"},
       {{fragment, "light.position - position", "position - light.position"}}},
      {"attenuation dropped", {"attenuation_missing"}, {{fragment, attenuation, "1.0"}}},
      {"attenuation without its square",
       {"attenuation_without_square"},
       {{fragment, attenuation, "1.0 / (light.constant + light.linear * d)"}}},
      {"attenuation with d for d squared",
       {"attenuation_square_of_d"},
       {{fragment, attenuation, "1.0 / (light.constant + light.linear * d + light.quadratic * d)"}}},
      {"attenuation without its linear term",
       {"attenuation_without_linear"},
       {{fragment, attenuation, "1.0 / (light.constant + light.quadratic * d * d)"}}},
      {"attenuation applied twice",
       {"attenuation_twice"},
       {{fragment, point_radiance, "light.radiance * (d > 0.0 ? attenuation * attenuation : 0.0)"}}},
      {"attenuation as 1 / d", {"attenuation_inverse"}, {{fragment, attenuation, "1.0 / d"}}},
      {"attenuation as 1 / d squared", {"attenuation_inverse_square"}, {{fragment, attenuation, "1.0 / (d * d)"}}},
      {"attenuation by the power 1.5", {}, {{fragment, attenuation, "1.0 / (0.3 + 0.2 * pow(d, 1.5))"}}},
      {"radiance not applied",
       {"radiance_missing"},
       {{fragment, point_radiance, "vec3(attenuation)"},
        {fragment, "Incident(-light.direction, light.radiance)", "Incident(-light.direction, vec3(1.0))"}}},
      {"the first point light missing",
       {"light_missing"},
       {{fragment, "reflected(n, v, t, arriving(pointLights[i], fs_in(FragPos)))",
         "(i > 0 ? reflected(n, v, t, arriving(pointLights[i], fs_in(FragPos))) : vec3(0.0))"}}},
      {"ambient missing", {"ambient_missing"}, {{fragment, summed, "with_lights(vec3(0.0), n, v, t)"}}},
      {"ambient twice", {"ambient_twice"}, {{fragment, summed, "with_lights(2.0 * ambient(t), n, v, t)"}}},
      {"ambient once a light",
       {"ambient_each_light"},
       {{fragment, summed, "with_lights(vec3(0.0), n, v, t)"},
        {fragment, "return colour * light.radiance;", "return colour * light.radiance + ambient(t);"}}},
      // Reflection.
      {"Phong and Blinn-Phong exchanged", {"phong_exchanged"}, {{fragment, "#ifdef BLINN", "#ifndef BLINN"}}},
      {"reflected direction reversed",
       {"reflect_reversed"},
       {{fragment, "2.0 * n_l * n - l, v", "l - 2.0 * n_l * n, v"}}},
      {"half vector not normalised", {"half_vector_not_normalised"}, {{fragment, "unit(l + v)", "(l + v)"}}},
      {"n.l not clamped", {"diffuse_not_clamped"}, {{fragment, "max(n_l, 0.0)", "n_l"}}},
      {"highlights gated by the horizon",
       {"specular_gate"},
       {{fragment, lobe, "float lobe = n_l > 0.0 ? pow(max(cosine, 0.0), glossiness) : 0.0;"}}},
      {"highlights missing", {"highlight_missing"}, {{fragment, lobe, "float lobe = 0.0;"}}},
      {"glossiness times four",
       {"glossiness_times_4"},
       {{fragment, lobe, "float lobe = pow(max(cosine, 0.0), 4.0 * glossiness);"}}},
      {"glossiness by four",
       {"glossiness_by_4"},
       {{fragment, lobe, "float lobe = pow(max(cosine, 0.0), 0.25 * glossiness);"}}},
      {"glossiness plus seven", {}, {{fragment, lobe, "float lobe = pow(max(cosine, 0.0), glossiness + 7.0);"}}},
      {"diffuse less by a tenth", {}, {{fragment, "vec3 colour = kd * t", "vec3 colour = 0.9 * kd * t"}}},
      {"an energy factor at the highlight",
       {},
       {{fragment, lobe, "float lobe = pow(max(cosine, 0.0), glossiness) * (glossiness + 8.0) / (8.0 * 3.14159265);"}}},
      // Textures.
      {"texture missing", {"texture_missing"}, {{fragment, texel, "vec3(1.0)"}}},
      {"texture half a texel to the right",
       {"texture_half_texel_less"},
       {{fragment, texel, "texture(tex, TEXTURE_AT - 0.5 / vec2(textureSize(tex, 0))).rgb"}}},
      {"texture half a texel to the left",
       {"texture_half_texel_more"},
       {{fragment, texel, "texture(tex, TEXTURE_AT + 0.5 / vec2(textureSize(tex, 0))).rgb"}}},
      {"texture on the highlight too",
       {"texture_on_highlight"},
       {{fragment, "colour += specular_colour * highlight", "colour += t * specular_colour * highlight"}}},
      {"texture's nearest texel",
       {"texture_nearest"},
       {{fragment, texel, "texelFetch(tex, ivec2(floor(fract(TEXTURE_AT) * vec2(textureSize(tex, 0)))), 0).rgb"}}},
      {"texture without its mip chain",
       {"texture_bilinear"},
       {{fragment, texel, "textureLod(tex, TEXTURE_AT, 0.0).rgb"}}},
      {"texture clamped",
       {"texture_clamped"},
       {{fragment, texel, "clamped(TEXTURE_AT).rgb"},
        {fragment, "uniform sampler2D tex;",
         "uniform sampler2D tex;\n"
         "vec4 clamped_at(vec2 uv, int level) {\n"
         "    vec2 margin = 0.5 / vec2(textureSize(tex, level));\n"
         "    return textureLod(tex, clamp(uv, margin, 1.0 - margin), float(level));\n"
         "}\n"
         "vec4 clamped(vec2 uv) {\n"
         "    vec2 size = vec2(textureSize(tex, 0)), right = dFdx(uv) * size, up = dFdy(uv) * size;\n"
         "    float detail = max(log2(max(length(right), length(up))), 0.0);\n"
         "    return mix(clamped_at(uv, int(detail)), clamped_at(uv, int(detail) + 1), fract(detail));\n"
         "}\n"}}},
      {"mip levels one too coarse", {"mip_bias_coarser"}, {{fragment, texel, "texture(tex, TEXTURE_AT, 1.0).rgb"}}},
      {"mip levels one too fine", {"mip_bias_finer"}, {{fragment, texel, "texture(tex, TEXTURE_AT, -1.0).rgb"}}},
      {"texture decoded in the shader",
       {"texture_decoded"},
       {{fragment, texel, "pow(texture(tex, TEXTURE_AT).rgb, vec3(2.2))"}}},
      // The measured table.
      {"table axes exchanged",
       {"merl_axes_exchanged"},
       {{fragment, table_place,
         "return vec3(phi_d * (180.0 / pi), 90.0 * sqrt(theta_h * (2.0 / pi)), theta_d * (180.0 / pi));"}}},
      {"theta_h without its root",
       {"merl_theta_h_without_root"},
       {{fragment, table_place,
         "return vec3(phi_d * (180.0 / pi), theta_d * (180.0 / pi), 90.0 * theta_h * (2.0 / pi));"}}},
      {"phi_d cut off at 0", {"merl_phi_d_cut"}, {{fragment, line_angle, "float angle = max(atan(p.y, p.x), 0.0);"}}},
      {"phi_d without its sign",
       {"merl_phi_d_mirrored"},
       {{fragment, line_angle, "float angle = abs(atan(p.y, p.x));"}}},
      {"no cosine", {"merl_cosine_missing"}, {{fragment, measured_cosine, "* light.radiance : vec3(0.0)"}}},
      {"scales of red and blue exchanged",
       {"merl_scales_exchanged"},
       {{fragment, brdf_value, "    return f * vec3(1.66, 1.0, 1.0 / 1.66);\n"}}},
      {"scales applied twice",
       {"merl_scales_twice"},
       {{fragment, brdf_value, "    return f * vec3(1.0, 1.15, 1.66) / 1500.0;\n"}}},
      {"scales not applied",
       {"merl_scales_missing"},
       {{fragment, brdf_value, "    return f * 1500.0 / vec3(1.0, 1.15, 1.66);\n"}}},
      {"unmeasured samples read as black", {"merl_unmeasured_black"}, {{fragment, measured, "vec3 f = sum.rgb;"}}},
      {"the nearest sample of the table",
       {"merl_nearest"},
       {{fragment, "#define MERL_LOOKUP LOOKUP_TRILINEAR\n", "#define MERL_LOOKUP LOOKUP_NEAREST\n"}}},
      {"samples at the starts of their bins",
       {"merl_trilinear_edge"},
       {{fragment, "#define MERL_LOOKUP LOOKUP_TRILINEAR\n", "#define MERL_LOOKUP LOOKUP_TRILINEAR_EDGE\n"}}},
      {"a measured surface with a tenth of white in it", {}, {{fragment, brdf_value, "    return f + 0.02;\n"}}},
      // Microfacets.
      {"roughness not squared", {"roughness_not_squared"}, {{fragment, "alpha = rough * rough;", "alpha = rough;"}}},
      {"a Fresnel factor without a clamp",
       {"fresnel_not_clamped"},
       {{fragment, "min(0.5 * sqrt(squared_sum), 1.0), 0.25 * dot(d, d)", "dot(s, v), 1.0 - dot(s, v) * dot(s, v)"}}},
      {"masking of microfacets missing",
       {"masking_missing"},
       {{fragment, "max(min(0.5 * n_l / smith_divisor(n_l, n_v, a), 0.5 / alpha), 0.0)", "0.25 / n_v"}}},
      // Shadow maps.
      {"the bias of shadow maps with its sign reversed",
       {"shadow_bias_reversed"},
       {{fragment, "at.z - map.texel * at.z * bias", "at.z + map.texel * at.z * bias"},
        {fragment, "at.z - map.texel * bias", "at.z + map.texel * bias"}}},
      {"shadow maps without bias",
       {"shadow_bias_missing"},
       {{fragment, "at.z - map.texel * at.z * bias", "at.z"}, {fragment, "at.z - map.texel * bias", "at.z"}}},
      {"the opposite face of a point light's shadow map",
       {"shadow_face_opposite"},
       {{fragment, "map.layer + face,", "map.layer + (face ^ 1),"}}},
      {"shadow maps turned over",
       {"shadow_rows_reversed"},
       {{fragment, "ivec3(texel, layer)", "ivec3(texel.x, last - texel.y, layer)"}}},
      {"no shadows", {"shadows_missing"}, {{fragment, "if (map.layer < 0) return 1.0;", "return 1.0;"}}},
      // What comes out.
      {"gamma at the end",
       {"gamma_encoded", "srgb_curve_added"},
       {{fragment, summed, "pow(max(with_lights(ambient(t), n, v, t), 0.0), vec3(1.0 / 2.2))"}}},
      {"gamma the wrong way",
       {"gamma_decoded", "srgb_curve_missing"},
       {{fragment, summed, "pow(max(with_lights(ambient(t), n, v, t), 0.0), vec3(2.2))"}}},
      {"red and blue exchanged in the shader",
       {"red_blue_exchanged"},
       {{fragment, summed, "with_lights(ambient(t), n, v, t).bgr"}}},
      {"tone mapping by c / (1 + c)",
       {},
       {{fragment, summed, "with_lights(ambient(t), n, v, t) / (1.0 + with_lights(ambient(t), n, v, t))"}}},
  };
}

/// `text` with all occurrences replaced; nothing if there is none.
std::optional<std::string> replaced(std::string text, std::string_view from, const std::string& to) {
  std::size_t at = text.find(from);
  if (at == std::string::npos) return std::nullopt;
  for (; at != std::string::npos; at = text.find(from, at + to.size())) text.replace(at, from.size(), to);
  return text;
}

std::string filled_in(std::string_view text, std::string_view word, std::size_t number) {
  return replaced(std::string(text), word, std::to_string(number)).value_or(std::string(text));
}

/// Both stages of an object with the fault; nothing if its GLSL lacks any of the texts.
struct ObjectGlsl {
  std::string vertex, fragment;
};
std::optional<ObjectGlsl> faulty_glsl(const Scene& scene, std::size_t number, const SeededFault& fault,
                                      const FaultImageSize& size) {
  std::size_t before = 0, all = 0;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (i < number) before += scene.objects[i].mesh->triangles.size();
    all += scene.objects[i].mesh->triangles.size();
  }
  ObjectGlsl glsl{own_vertex_glsl(*scene.objects[number].mesh, GlslDialect::core_330),
                  own_fragment_glsl(scene, *scene.objects[number].mesh, scene.objects[number].material,
                                    scene.objects[number].two_sided, MerlFilter::manual, GlslDialect::core_330)};
  bool any = false;
  for (const Replacement& replacement : fault.glsl) {
    std::string to = filled_in(replacement.to, "@WIDTH@", static_cast<std::size_t>(size.width));
    to = filled_in(to, "@HEIGHT@", static_cast<std::size_t>(size.height));
    to = filled_in(filled_in(to, "@FIRST_TRIANGLE@", before), "@TRIANGLES@", all);
    std::string& text = replacement.stage == FaultyStage::vertex ? glsl.vertex : glsl.fragment;
    std::optional<std::string> with = replaced(text, replacement.from, to);
    any |= with.has_value();
    if (with) text = std::move(*with);
  }
  if (!any) return std::nullopt;
  return glsl;
}

std::string save(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << text;
  return path.string();
}

} // namespace

const std::vector<SeededFault>& seeded_faults() {
  static const std::vector<SeededFault> all = [] {
    std::vector<SeededFault> faults = glsl_faults();
    for (const auto list : {seeded_scene_faults, seeded_map_faults, seeded_image_faults})
      for (SeededFault& fault : list()) faults.push_back(std::move(fault));
    return faults;
  }();
  return all;
}

std::optional<Scene> with_fault(const Scene& right, const SeededFault& fault, const FaultImageSize& size,
                                const std::filesystem::path& folder) {
  if (fault.scene) return fault.scene(right, size);
  if (fault.image) return right;
  Scene scene = right;
  bool any = false;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (!has_own_glsl(right.objects[i].material)) continue;
    const std::optional<ObjectGlsl> glsl = faulty_glsl(right, i, fault, size);
    if (!glsl) continue;
    any = true;
    const std::string name = "object" + std::to_string(i);
    scene.objects[i].vertex_shader_path = save(folder / (name + "_vs.glsl"), glsl->vertex);
    scene.objects[i].fragment_shader_path = save(folder / (name + "_fs.glsl"), glsl->fragment);
  }
  if (!any) return std::nullopt;
  return scene;
}

} // namespace refraster
