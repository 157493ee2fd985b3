#include "gl/glsl/own_glsl.h"

#include <algorithm>
#include <cctype>
#include <locale>
#include <sstream>

namespace refraster {
namespace {

std::string_view version(GlslDialect dialect) {
  return dialect == GlslDialect::core_330 ? "#version 330 core\n"
                                          : "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision "
                                            "highp sampler3D;\nprecision highp sampler2DArray;\n";
}

/// "trilinear-log" gives LOOKUP_TRILINEAR_LOG.
std::string constant(std::string_view prefix, std::string_view name) {
  std::string word(prefix);
  for (const char c : name) word += c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return word;
}

/// Numbers the names of an enum, and says which one holds.
template <class Enum>
void define_choice(std::ostream& text, std::string_view what, std::string_view prefix, Enum chosen) {
  for (const auto& [value, name] : EnumNames<Enum>::names)
    text << "#define " << constant(prefix, name) << " " << static_cast<int>(value) << "\n";
  text << "#define " << what << " " << constant(prefix, name_of(chosen)) << "\n";
}

std::string type_of(const auto& attribute) {
  return "vec" + std::to_string(attribute.components);
}

/// Whether our shaders hand the attribute over. What the lecture's do is always there, since blocks must be the same on
/// both sides and one of the two may be a file of the scene; what else there is, where the mesh has it.
bool is_handed_over(const auto& attribute, const Mesh& mesh) {
  constexpr std::string_view by_the_lecture[] = {"FragPos", "Normal", "TexCoord"};
  return std::ranges::count(by_the_lecture, attribute.varying) > 0 || !(mesh.*attribute.values).empty();
}

/// What the shaders hand over, declared: `way` is "in" or "out". Reached as fs_in(name) and vs_out(name).
std::string varyings(const Mesh& mesh, GlslDialect dialect, const std::string& way) {
  const std::string block = way == "in" ? "fs_in" : "vs_out";
  std::string members;
  for_each_vertex_attribute([&](const auto& attribute) {
    if (!is_handed_over(attribute, mesh)) return;
    members += (dialect == GlslDialect::es_300 ? way + " " : "    ") + type_of(attribute) + " ";
    members.append(attribute.varying).append(";\n");
  });
  if (dialect == GlslDialect::es_300) // has no blocks between stages
    return members + "#define " + block + "(name) name\n";
  return way + " VS_OUT {\n" + members + "} " + block + "_block;\n#define " + block + "(name) " + block +
         "_block.name\n";
}

/// An attribute as the fragment shader gets it.
std::string passed_on(const auto& attribute) {
  const std::string in(attribute.input);
  switch (attribute.transformed) {
  case Transformed::as_position:
    return "vec3(model * vec4(" + in + ", 1.0))";
  case Transformed::as_normal:
    return "normalMatrix * " + in;
  case Transformed::as_tangent:
    return attribute.components == 4 ? "vec4(unit(mat3(model) * " + in + ".xyz), " + in + ".w * modelHandedness)"
                                     : "unit(mat3(model) * " + in + ")";
  case Transformed::as_is:
    return in;
  }
  return {};
}

/// "PointLight" of "pointLights".
std::string type_of(const LightNames& lights) {
  std::string type(lights.glsl.substr(0, lights.glsl.size() - 1));
  type[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(type[0])));
  return type;
}

/// The arrays of lights, and with_lights(), which adds what is reflected of each in the order of the lists.
std::string light_sum(const Scene& scene) {
  std::string arrays, loops;
  for_each_light_list(scene, [&]<class Light>(const std::vector<Light>& lights) {
    if (lights.empty()) return;
    const std::string name(Light::names.glsl), count = std::to_string(lights.size());
    arrays += "uniform " + type_of(Light::names) + " " + name + "[" + count + "];\n";
    const std::string begin = "    for (int i = 0; i < " + count + "; ++i) ",
                      light = "arriving(" + name + "[i], fs_in(FragPos))";
    if (std::ranges::none_of(lights, [](const Light& one) { return one.shadow == Shadow::map; })) {
      loops += begin + "sum += reflected(n, v, t, " + light + ");\n";
      return;
    }
    loops += begin + "{\n        Incident light = " + light + ";\n        light.radiance *= visibility(" + name +
             "[i], fs_in(FragPos), fs_in(Normal));\n        sum += reflected(n, v, t, light);\n    }\n";
  });
  return arrays + "vec3 with_lights(vec3 sum, vec3 n, vec3 v, vec3 t) {\n" + loops + "    return sum;\n}\n";
}

void define(std::ostream& text, std::string_view name, bool wanted) {
  if (wanted) text << "#define " << name << "\n";
}

/// HAS_TEXTURE, and TEXTURE_AT for where it is read.
void define_texture(std::ostream& text, const TextureSlot& slot, const TextureMap& map) {
  if (!map.texture) return;
  const bool moved = map.scale != Double2(1) || map.offset != Double2(0);
  define(text, constant("HAS_", slot.name), true);
  text << "#define " << constant("", slot.name) << "_AT ";
  if (!moved) text << "fs_in(TexCoord)\n";
  else
    text << "(fs_in(TexCoord) * " << slot.place << ".xy + " << slot.place << ".zw)\nuniform vec4 " << slot.place
         << "; // scale, offset\n";
}

/// Textures and light of its own.
void define_colours(std::ostream& text, const Material& material) {
  for (const TextureSlot& slot : texture_slots)
    if (slot.use == SlotUse::colours && shows(material, slot)) define_texture(text, slot, material.*slot.map);
  define(text, "EMISSIVE", material.emissive != Double3(0));
}

void define_function(std::ostream& text, const PhongParameters& function, const Material& material, MerlFilter) {
  define_colours(text, material);
  define(text, "SPECULAR", function.ks != Double3(0));
  define(text, "ZERO_GLOSSINESS", function.glossiness == 0);
  define(text, "SPECULAR_GATE", function.specular_gate == SpecularGate::cut_below_horizon);
  define(text, "BLINN", std::holds_alternative<BlinnPhong>(material.fragment_function));
}

void define_function(std::ostream& text, const Merl& function, const Material&, MerlFilter filter) {
  define_choice(text, "MERL_LOOKUP", "LOOKUP_", function.lookup);
  define_choice(text, "MERL_ANGLES", "ANGLES_", function.angles);
  define(text, "MERL_HARDWARE_FILTER", filter == MerlFilter::hardware);
  text << "#define MERL_LOG_EPSILON " << std::showpoint << MerlTable::log_epsilon << "\n";
}

void define_function(std::ostream& text, const Microfacet& function, const Material& material, MerlFilter) {
  define_colours(text, material);
  define_choice(text, "MICROFACET_FRESNEL", "FRESNEL_", function.fresnel);
}

/// Of any fragment function.
void define_opacity(std::ostream& text, const Material& material) {
  if (!material.has_cut_outs()) return;
  for (const TextureSlot& slot : texture_slots)
    if (slot.map == &Material::opacity_map) define_texture(text, slot, material.opacity_map);
}

/// The part of glsl_text; none of a fragment function that was added since.
template <class SomeFunction>
std::string_view formulas_of(const SomeFunction&) {
  if constexpr (std::is_same_v<SomeFunction, Phong> || std::is_same_v<SomeFunction, BlinnPhong>) return glsl_text.phong;
  if constexpr (std::is_same_v<SomeFunction, Merl>) return glsl_text.merl;
  if constexpr (std::is_same_v<SomeFunction, Microfacet>) return glsl_text.microfacet;
  return {};
}

} // namespace

bool has_own_glsl(const Material& material) {
  return !material.user_function &&
         std::visit([](const auto& function) { return !formulas_of(function).empty(); }, material.fragment_function);
}

bool has_own_glsl(const LightNames& lights) {
  return glsl_text.surface.find("arriving(" + type_of(lights) + " ") != std::string_view::npos;
}

bool has_own_glsl(const TextureSlot& slot) {
  const std::string declared = "sampler2D " + std::string(slot.sampler) + ";";
  const std::string_view texts[] = {glsl_text.colours, glsl_text.phong, glsl_text.microfacet, glsl_text.opacity,
                                    glsl_text.normal_map};
  return std::any_of(std::begin(texts), std::end(texts),
                     [&](std::string_view text) { return text.find(declared) != std::string_view::npos; });
}

bool has_own_glsl(std::string_view varying) {
  const std::string read = "fs_in(" + std::string(varying) + ")";
  const std::string_view texts[] = {glsl_text.surface, glsl_text.colours,    glsl_text.phong,
                                    glsl_text.merl,    glsl_text.microfacet, glsl_text.main};
  return std::any_of(std::begin(texts), std::end(texts),
                     [&](std::string_view text) { return text.find(read) != std::string_view::npos; });
}

std::vector<std::string_view> without_glsl(const Scene& scene, const Object& object) {
  std::vector<std::string_view> without;
  for_each_vertex_attribute([&](const auto& attribute) {
    if (!(object.mesh.get()->*attribute.values).empty() && !has_own_glsl(attribute.varying))
      without.push_back(attribute.words);
  });
  for (const TextureSlot& slot : texture_slots)
    if ((object.material.*slot.map).texture && !has_own_glsl(slot)) without.push_back(slot.key);
  for_each_light_list(scene, [&]<class Light>(const std::vector<Light>& lights) {
    if (!lights.empty() && !has_own_glsl(Light::names)) without.push_back(Light::names.words);
  });
  return without;
}

bool reads_logarithms(MerlLookup lookup) {
  return lookup == MerlLookup::trilinear_log || lookup == MerlLookup::tricubic_log;
}

std::string own_vertex_glsl(const Mesh& mesh, GlslDialect dialect) {
  std::string inputs, assignments;
  int location = 0;
  for_each_vertex_attribute([&](const auto& attribute) {
    const int here = location++;
    if (!is_handed_over(attribute, mesh)) return;
    inputs += "layout(location = " + std::to_string(here) + ") in " + type_of(attribute) + " ";
    inputs.append(attribute.input).append(";\n");
    if (attribute.transformed == Transformed::as_tangent) inputs += "uniform float modelHandedness;\n";
    assignments.append("    vs_out(").append(attribute.varying).append(") = ").append(passed_on(attribute)) += ";\n";
  });
  return std::string(version(dialect)).append(inputs).append(varyings(mesh, dialect, "out")).append(glsl_text.vertex) +
         "\nvoid pass_attributes() {\n" + assignments + "}\n";
}

std::string own_fragment_glsl(const Scene& scene, const Mesh& mesh, const Material& material, TwoSided two_sided,
                              MerlFilter filter, GlslDialect dialect) {
  std::ostringstream text;
  text.imbue(std::locale::classic()); // whatever the program's own is
  text << version(dialect);
  define(text, "HAS_COLOURS", !mesh.colours.empty());
  const std::string_view formulas = std::visit(
      [&](const auto& function) {
        if constexpr (requires { define_function(text, function, material, filter); })
          define_function(text, function, material, filter);
        return formulas_of(function);
      },
      material.fragment_function);
  define_opacity(text, material);
  define(text, "TWO_SIDED", two_sided == TwoSided::yes);
  const bool turns_normals = material.turns_normals() && !mesh.tangents.empty();
  define(text, "HAS_TANGENTS", turns_normals);
  for (const TextureSlot& slot : texture_slots)
    if (turns_normals && (slot.map == &Material::normal_map || slot.map == &Material::bump_map))
      define_texture(text, slot, material.*slot.map);
  const bool has_maps = has_shadows(scene, Shadow::map);
  define(text, "SHADOW_MAPS", has_maps);
  text << varyings(mesh, dialect, "in") << glsl_text.surface;
  if (has_maps) text << glsl_text.shadow;
  if (turns_normals) text << glsl_text.normal_map;
  if (formulas.data() != glsl_text.merl.data()) text << glsl_text.colours; // a measured surface has none
  text << formulas << light_sum(scene) << glsl_text.opacity << glsl_text.main;
  return text.str();
}

std::string own_ids_glsl(const Mesh& mesh, const Material& material) {
  constexpr GlslDialect dialect = GlslDialect::core_330;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << version(dialect);
  define_opacity(text, material);
  if (material.has_cut_outs()) text << varyings(mesh, dialect, "in") << glsl_text.opacity;
  text << glsl_text.ids;
  return text.str();
}

} // namespace refraster
