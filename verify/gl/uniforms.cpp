#include "verify/gl/uniforms.h"

#include <algorithm>
#include <optional>
#include <string_view>

namespace refraster {
namespace {

/// The largest number of a list, above or below: "pointLights[3].position" of the list pointLights is 3.
std::optional<int> element_of(const std::string& uniform, std::string_view list) {
  if (!uniform.starts_with(list) || uniform.size() <= list.size() || uniform[list.size()] != '[') return std::nullopt;
  return std::atoi(uniform.c_str() + list.size() + 1);
}

struct LightList {
  const char *list, *count, *lights;
};
constexpr LightList light_lists[] = {{"pointLights", "pointLightCount", "point lights"},
                                     {"directionLights", "directionLightCount", "direction lights"}};

struct ActiveUniform {
  std::string name;
  GLenum type = 0;
  GLint location = -1;
};

/// Those outside of blocks; the elements of an array each for itself.
std::vector<ActiveUniform> active_uniforms(const GlApi& gl, GLuint program) {
  GLint count = 0, longest = 0;
  gl.GetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
  gl.GetProgramiv(program, GL_ACTIVE_UNIFORM_MAX_LENGTH, &longest);
  std::vector<ActiveUniform> uniforms;
  std::string room(static_cast<std::size_t>(std::max(longest, 1)), '\0');
  for (GLint i = 0; i < count; ++i) {
    GLsizei length = 0;
    GLint size = 0;
    ActiveUniform uniform;
    gl.GetActiveUniform(program, static_cast<GLuint>(i), longest, &length, &size, &uniform.type, room.data());
    uniform.name = room.substr(0, static_cast<std::size_t>(length));
    uniform.location = gl.GetUniformLocation(program, uniform.name.c_str());
    if (uniform.location >= 0) uniforms.push_back(uniform); // else it is built in, or in a block
  }
  return uniforms;
}

std::string_view type_name(GLenum type) {
  switch (type) {
  case GL_FLOAT:
    return "float";
  case GL_FLOAT_VEC2:
    return "vec2";
  case GL_FLOAT_VEC3:
    return "vec3";
  case GL_FLOAT_VEC4:
    return "vec4";
  case GL_INT:
    return "int";
  case GL_UNSIGNED_INT:
    return "uint";
  case GL_BOOL:
    return "bool";
  case GL_FLOAT_MAT3:
    return "mat3";
  case GL_FLOAT_MAT4:
    return "mat4";
  case GL_SAMPLER_2D:
    return "sampler2D";
  case GL_SAMPLER_3D:
    return "sampler3D";
  default:
    return "another type";
  }
}

/// The type that a value is for. Samplers and bools are set as an int is.
struct Expected {
  std::string_view name;
  std::string_view operator()(float) const { return "float"; }
  std::string_view operator()(const Float3&) const { return "vec3"; }
  std::string_view operator()(const Float3x3&) const { return "mat3"; }
  std::string_view operator()(const Float4x4&) const { return "mat4"; }
  std::string_view operator()(int) const {
    if (name == "tex") return "sampler2D";
    if (name == "merlBrdf") return "sampler3D";
    return name == "specularGate" ? "bool" : "int";
  }
};

} // namespace

MatricesBlock matrices_block(const Camera& camera, double aspect) {
  return {Float4x4(view_from_world(camera)), Float4x4(clip_from_view(camera, aspect))};
}

UniformValues scene_uniforms(const Scene& scene) {
  UniformValues values;
  values["viewPos"] = Float3(scene.camera.position);
  values["pointLightCount"] = static_cast<int>(scene.point_lights.size());
  for (std::size_t i = 0; i < scene.point_lights.size(); ++i) {
    const PointLight& light = scene.point_lights[i];
    const bool attenuated = light.constant > 0 || light.linear > 0 || light.quadratic > 0;
    const std::string at = "pointLights[" + std::to_string(i) + "].";
    values[at + "position"] = Float3(light.position);
    values[at + "radiance"] = Float3(light.radiance);
    values[at + "constant"] = attenuated ? static_cast<float>(light.constant) : 1.0f; // all 0 means none
    values[at + "linear"] = static_cast<float>(light.linear);
    values[at + "quadratic"] = static_cast<float>(light.quadratic);
  }
  values["directionLightCount"] = static_cast<int>(scene.direction_lights.size());
  for (std::size_t i = 0; i < scene.direction_lights.size(); ++i) {
    const std::string at = "directionLights[" + std::to_string(i) + "].";
    values[at + "direction"] = Float3(normalize(scene.direction_lights[i].direction));
    values[at + "radiance"] = Float3(scene.direction_lights[i].radiance);
  }
  return values;
}

UniformValues object_uniforms(const Object& object, const Double4x4& clip_from_world) {
  const ObjectTransform transform = object_transform(object, clip_from_world);
  UniformValues values;
  values["model"] = Float4x4(transform.world_from_object);
  values["clipFromObject"] = Float4x4(transform.clip_from_object);
  values["normalMatrix"] = Float3x3(transform.world_from_normal);
  values["tex"] = texture_unit;
  values["merlBrdf"] = merl_unit;
  std::visit(
      [&](const auto& model) {
        if constexpr (std::is_base_of_v<PhongParameters, std::decay_t<decltype(model)>>) {
          values["ka"] = Float3(model.ka);
          values["kd"] = Float3(model.kd);
          values["ks"] = Float3(model.ks);
          values["glossiness"] = static_cast<float>(model.glossiness);
          values["specularGate"] = model.specular_gate == SpecularGate::open ? 0 : 1;
        }
      },
      object.material.model);
  return values;
}

std::vector<UniformSetting> settings(const GlApi& gl, GLuint program, const UniformValues& values,
                                     std::vector<std::string>& warnings) {
  const std::vector<ActiveUniform> uniforms = active_uniforms(gl, program);
  UniformValues given = values;
  for (const LightList& lights : light_lists) {
    const int count = std::get<int>(given.at(lights.count));
    int room = 0;
    for (const ActiveUniform& uniform : uniforms)
      room = std::max(room, element_of(uniform.name, lights.list).value_or(-1) + 1);
    if (room > 0 && room < count) {
      warnings.push_back(std::string(lights.list) + " has room for " + std::to_string(room) + " of the scene's " +
                         std::to_string(count) + " " + lights.lights + ": the others are left out");
      given[lights.count] = room;
    }
  }

  std::vector<UniformSetting> found;
  for (const ActiveUniform& uniform : uniforms) {
    const auto value = given.find(uniform.name);
    if (value == given.end()) {
      // Elements beyond the scene's lights stay 0.
      const bool spare = std::any_of(std::begin(light_lists), std::end(light_lists), [&](const LightList& lights) {
        const auto element = element_of(uniform.name, lights.list);
        return element && *element >= std::get<int>(given.at(lights.count));
      });
      if (!spare)
        warnings.push_back("uniform " + std::string(type_name(uniform.type)) + " " + uniform.name +
                           " is not one that refraster sets: it stays 0");
      continue;
    }
    const std::string_view expected = std::visit(Expected{uniform.name}, value->second);
    if (type_name(uniform.type) != expected) {
      warnings.push_back("uniform " + uniform.name + ": found " + std::string(type_name(uniform.type)) + ", expected " +
                         std::string(expected) + ": it stays 0");
      continue;
    }
    found.push_back({uniform.location, value->second});
  }
  return found;
}

void set_uniform(const GlApi& gl, const UniformSetting& setting) {
  struct Set {
    const GlApi& gl;
    GLint at;
    void operator()(float x) const { gl.Uniform1f(at, x); }
    void operator()(int x) const { gl.Uniform1i(at, x); }
    void operator()(const Float3& x) const { gl.Uniform3fv(at, 1, &x[0]); }
    void operator()(const Float3x3& x) const { gl.UniformMatrix3fv(at, 1, GL_FALSE, &x[0][0]); }
    void operator()(const Float4x4& x) const { gl.UniformMatrix4fv(at, 1, GL_FALSE, &x[0][0]); }
  };
  std::visit(Set{gl, setting.location}, setting.value);
}

} // namespace refraster
