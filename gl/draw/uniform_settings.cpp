#include "gl/context/gl_errors.h"
#include "gl/draw/uniforms.h"
#include "gl/program/glsl_types.h"
#include "gl/program/introspection.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <tuple>
#include <vector>

namespace refraster {
namespace {

/// The largest number of a list, above or below: "pointLights[3].position" of the list pointLights is 3.
std::optional<int> element_of(const std::string& uniform, std::string_view list) {
  if (!uniform.starts_with(list) || uniform.size() <= list.size() || uniform[list.size()] != '[') return std::nullopt;
  return std::atoi(uniform.c_str() + list.size() + 1);
}

constexpr std::array all_light_names =
    std::apply([]<class... Light>(std::vector<Light> Scene::*...) { return std::array{Light::names...}; }, light_lists);

/// Set for some fragment functions only.
constexpr std::string_view of_some_functions[] = {"ka",           "kd",       "ks",        "glossiness",
                                                  "specularGate", "merlBrdf", "baseColor", "metallic",
                                                  "roughness",    "ior",      "eta",       "k"};

/// The type that a value is for. Samplers and bools are set as an int is.
struct Expected {
  std::string_view name;
  GLenum operator()(float) const { return GL_FLOAT; }
  GLenum operator()(const Float2&) const { return GL_FLOAT_VEC2; }
  GLenum operator()(const Float3&) const { return GL_FLOAT_VEC3; }
  GLenum operator()(const Float4&) const { return GL_FLOAT_VEC4; }
  GLenum operator()(const Float3x3&) const { return GL_FLOAT_MAT3; }
  GLenum operator()(const Float4x4&) const { return GL_FLOAT_MAT4; }
  GLenum operator()(int) const {
    for (const TextureSlot& slot : texture_slots)
      if (name == slot.sampler) return GL_SAMPLER_2D;
    if (name == "merlBrdf") return GL_SAMPLER_3D;
    if (name == "shadowMaps") return GL_SAMPLER_2D_ARRAY;
    if (name == "shadowMapsCompared") return GL_SAMPLER_2D_ARRAY_SHADOW;
    return name == "specularGate" ? GL_BOOL : GL_INT;
  }
};

/// "lights[].colour" for "lights[12].colour": the same for all elements of arrays.
std::string without_indices(const std::string& name) {
  std::string general;
  for (const char c : name)
    if (general.empty() || general.back() != '[' || c < '0' || c > '9') general += c;
  return general;
}

/// A program's value of each component of all elements, as floats.
std::vector<float> initial_values(const GlApi& gl, GLuint program, const ProgramVariable& uniform) {
  const GlslType& type = glsl_type(uniform.type);
  const auto components = static_cast<std::size_t>(type.columns * type.components);
  std::vector<float> values;
  for (GLint i = 0; i < uniform.size; ++i) {
    const std::string element = array_name(uniform.name) + "[" + std::to_string(i) + "]";
    const GLint location = uniform.size > 1 ? gl.GetUniformLocation(program, element.c_str()) : uniform.location;
    if (location < 0) continue; // an element that the compiler has removed
    values.resize(values.size() + components);
    gl.GetUniformfv(program, location, &values[values.size() - components]);
  }
  return values;
}

std::string text_of(const std::vector<float>& values) {
  std::string text;
  for (const float value : values) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.9g", static_cast<double>(value));
    text += (text.empty() ? "" : ", ") + std::string(digits);
  }
  return values.size() == 1 ? text : "(" + text + ")";
}

/// What becomes of uniforms of one type that nobody sets: those of one name but for indices. Samplers are set to a unit
/// of their own.
std::string leave(const GlApi& gl, GLuint program, const std::vector<const ProgramVariable*>& uniforms,
                  DummyTextures& dummies) {
  const GlslType& type = glsl_type(uniforms.front()->type);
  if (type.kind == GlslKind::image) return "it reads 0, and what is written to it is lost";
  if (type.kind == GlslKind::sampler) {
    const GLint unit = dummies.unit_of(type.type);
    gl.UseProgram(program);
    for (const ProgramVariable* const uniform : uniforms)
      gl.Uniform1iv(uniform->location, uniform->size,
                    std::vector<GLint>(static_cast<std::size_t>(uniform->size), unit).data());
    return type.base == GlslBase::depth ? "it compares with depth 1" : "it reads (0, 0, 0, 1)";
  }
  if (type.kind == GlslKind::unknown) return "nothing is known of its value";
  // Since it is never set, it has the value of its declaration: GLSL 4.60, 4.3.5.
  std::vector<float> values;
  for (const ProgramVariable* const uniform : uniforms) {
    const std::vector<float> more = initial_values(gl, program, *uniform);
    values.insert(values.end(), more.begin(), more.end());
  }
  if (std::all_of(values.begin(), values.end(), [](float value) { return value == 0; })) return "it stays 0";
  if (values.size() > 4) return "it keeps its initial value";
  return "it keeps its initial value, " + text_of(values);
}

/// Cuts the counts of lights to the room in the program's arrays.
void cut_lights(const std::vector<ProgramVariable>& uniforms, UniformValues& given,
                std::vector<std::string>& warnings) {
  for (const LightNames& lights : all_light_names) {
    const int count = std::get<int>(given.at(count_uniform(lights)));
    int room = 0;
    for (const ProgramVariable& uniform : uniforms)
      room = std::max(room, element_of(uniform.name, lights.glsl).value_or(-1) + 1);
    if (room > 0 && room < count) {
      warnings.push_back(std::string(lights.glsl) + " has room for " + std::to_string(room) + " of the scene's " +
                         std::to_string(count) + " " + std::string(lights.words) + ": the others are left out");
      given[count_uniform(lights)] = room;
    }
  }
}

/// Elements beyond the scene's lights, which stay 0.
bool is_spare(const ProgramVariable& uniform, const UniformValues& given) {
  return std::any_of(all_light_names.begin(), all_light_names.end(), [&](const LightNames& lights) {
    const auto element = element_of(uniform.name, lights.glsl);
    return element && *element >= std::get<int>(given.at(count_uniform(lights)));
  });
}

} // namespace

std::vector<UniformSetting> settings(const GlApi& gl, GLuint program, const UniformValues& values,
                                     std::string_view function, DummyTextures& dummies,
                                     std::vector<std::string>& warnings) {
  const std::vector<ProgramVariable> uniforms = active_uniforms(gl, program);
  UniformValues given = values;
  cut_lights(uniforms, given, warnings);

  std::vector<UniformSetting> found;
  std::vector<std::vector<const ProgramVariable*>> left; // by name without indices, and type
  for (const ProgramVariable& uniform : uniforms) {
    const auto value = given.find(uniform.name);
    if (value != given.end() && uniform.type == std::visit(Expected{uniform.name}, value->second)) {
      found.push_back({uniform.location, value->second});
      continue;
    }
    const bool is_sampler = glsl_type(uniform.type).kind == GlslKind::sampler;
    if (value == given.end() && !is_sampler && is_spare(uniform, given)) continue;
    const auto alike = std::find_if(left.begin(), left.end(), [&](const auto& group) {
      return group.front()->type == uniform.type &&
             without_indices(group.front()->name) == without_indices(uniform.name);
    });
    if (alike == left.end()) left.push_back({&uniform});
    else alike->push_back(&uniform);
  }

  for (const auto& group : left) {
    const ProgramVariable& uniform = *group.front();
    const std::string name = array_name(uniform.name), effect = leave(gl, program, group, dummies),
                      declared = "uniform " + declaration(uniform.name, uniform.type, uniform.size);
    if (const auto value = given.find(name); value != given.end())
      warnings.push_back("uniform " + name + ": found " + array_type_name(uniform.name, uniform.type, uniform.size) +
                         ", expected " + glsl_type(std::visit(Expected{name}, value->second)).name + ": " + effect);
    else if (std::count(std::begin(of_some_functions), std::end(of_some_functions), name) > 0)
      warnings.push_back(declared + " is not set for the fragment function " + std::string(function) + ": " + effect);
    else
      warnings.push_back(declared +
                         (group.size() > 1 ? " (and " + std::to_string(group.size() - 1) + " more elements)" : "") +
                         " is not one that refraster sets: " + effect);
  }
  return found;
}

} // namespace refraster
