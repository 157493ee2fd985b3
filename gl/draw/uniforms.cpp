#include "gl/draw/uniforms.h"

#include "shading/light.h"
#include "shading/normal_map.h"

namespace refraster {
namespace {

/// The parameters of a fragment function of the user's: uniforms of their names.
struct ParameterUniforms final : FieldVisitor {
  explicit ParameterUniforms(UniformValues& its_values) : values(its_values) {}
  void field(std::string_view name, double& value, const Range&, std::string_view) override {
    values[std::string(name)] = static_cast<float>(value);
  }
  void field(std::string_view name, Double3& value, const Range&, std::string_view) override {
    values[std::string(name)] = Float3(value);
  }
  void field(std::string_view name, NamedValue& value, const Range&, std::string_view) override {
    values[std::string(name)] = static_cast<int>(value.index);
  }
  UniformValues& values;
};

UniformValue uniform_of(double value, const Range&) {
  return static_cast<float>(value);
}
UniformValue uniform_of(const Double3& value, const Range& range) {
  return Float3(range.zero == Zero::excluded ? normalize(value) : value);
}
template <NamedEnum Enum>
UniformValue uniform_of(Enum value, const Range&) {
  return static_cast<int>(value);
}

/// Of a light whose uniforms begin with `at`; null: it has no map. `layer`: the next that is free.
void add_shadow(const LightView* view, const std::string& at, std::size_t& layer, UniformValues& values) {
  const auto set = [&](const char* member, const UniformValue& value) { values[at + "shadow." + member] = value; };
  const LightView of = view ? *view : LightView{};
  set("layer", view ? static_cast<int>(layer) : -1);
  set("size", of.map.size);
  set("taps", taps_across(of.map.filter) * taps_across(of.map.filter));
  const std::pair<const char*, double> numbers[] = {{"bias", of.map.bias},
                                                    {"slopeBias", of.map.slope_bias},
                                                    {"texel", of.constants.texel},
                                                    {"scale", of.constants.texels},
                                                    {"middle", of.constants.half_size},
                                                    {"near", of.near},
                                                    {"depthScale", of.constants.depth_scale},
                                                    {"depthOffset", of.constants.depth_offset}};
  for (const auto& [member, value] : numbers) set(member, static_cast<float>(value));
  set("origin", Float3(of.origin)), set("right", Float3(of.axes.right));
  set("up", Float3(of.axes.up)), set("ahead", Float3(of.axes.ahead));
  if (view) layer += view->faces();
}

} // namespace

std::string count_uniform(const LightNames& names) {
  return std::string(names.glsl.substr(0, names.glsl.size() - 1)) + "Count"; // of one of them
}

MatricesBlock matrices_block(const Camera& camera, double aspect) {
  return {Float4x4(view_from_world(camera)), Float4x4(clip_from_view(camera, aspect))};
}

UniformValues scene_uniforms(const Scene& scene, std::span<const LightView> views) {
  UniformValues values;
  std::size_t next = 0, layer = 0;
  if (!views.empty()) values["shadowMaps"] = shadow_unit, values["shadowMapsCompared"] = compared_shadow_unit;
  values["viewPos"] = Float3(scene.camera.position);
  for_each_light_list(scene, [&]<class Light>(const std::vector<Light>& lights) {
    values[count_uniform(Light::names)] = static_cast<int>(lights.size());
    for (std::size_t i = 0; i < lights.size(); ++i) {
      const std::string at = std::string(Light::names.glsl) + "[" + std::to_string(i) + "].";
      if (!views.empty()) add_shadow(lights[i].shadow == Shadow::map ? &views[next++] : nullptr, at, layer, values);
      const Light light = textbook_light(lights[i]);
      Light::fields(light, [&]<class Value>(const std::string& name, const Value& value, const Range& range, auto&&) {
        if constexpr (!std::is_same_v<Value, CastShadow>) values[at + name] = uniform_of(value, range);
      });
    }
  });
  return values;
}

UniformValues object_uniforms(const Object& object, const Double4x4& clip_from_world) {
  const ObjectTransform transform = object_transform(object, clip_from_world);
  UniformValues values;
  values["model"] = Float4x4(transform.world_from_object);
  values["clipFromObject"] = Float4x4(transform.clip_from_object);
  values["normalMatrix"] = Float3x3(transform.world_from_normal);
  values["frontSign"] = values["modelHandedness"] = static_cast<float>(transform.handedness);
  for (std::size_t i = 0; i < texture_slots.size(); ++i) {
    const TextureSlot& slot = texture_slots[i];
    const TextureMap& map = object.material.*slot.map;
    values[std::string(slot.sampler)] = static_cast<int>(i);
    values[std::string(slot.place)] = Float4(Float2(map.scale), Float2(map.offset));
  }
  values["opacityThreshold"] = static_cast<float>(object.material.opacity_threshold);
  values["emissive"] = Float3(object.material.emissive);
  values["normalFactors"] = Float2(normal_factors(object.material));
  values["bumpFactors"] = Float2(slope_factors(object.material));
  if (object.material.bump_map.texture) values["bumpTexel"] = Float2(texel_size(object.material.bump_map));
  if (object.material.user_function) {
    ParameterUniforms parameters(values);
    object.material.user_function->copy()->fields(parameters);
    return values;
  }
  std::visit(
      [&](const auto& function) {
        if constexpr (std::is_base_of_v<PhongParameters, std::decay_t<decltype(function)>>) {
          values["ka"] = Float3(function.ka);
          values["kd"] = Float3(function.kd);
          values["ks"] = Float3(function.ks);
          values["glossiness"] = static_cast<float>(function.glossiness);
          values["specularGate"] = function.specular_gate == SpecularGate::open ? 0 : 1;
        } else if constexpr (std::is_same_v<Microfacet, std::decay_t<decltype(function)>>) {
          values["baseColor"] = Float3(function.base_color);
          values["metallic"] = static_cast<float>(function.metallic);
          values["roughness"] = static_cast<float>(function.roughness);
          values["ior"] = static_cast<float>(function.ior);
          values["eta"] = Float3(function.eta);
          values["k"] = Float3(function.k);
        } else if constexpr (std::is_same_v<Merl, std::decay_t<decltype(function)>>) {
          values["merlBrdf"] = merl_unit;
        }
      },
      object.material.fragment_function);
  return values;
}

void set_uniform(const GlApi& gl, const UniformSetting& setting) {
  struct Set {
    const GlApi& gl;
    GLint at;
    void operator()(float x) const { gl.Uniform1f(at, x); }
    void operator()(int x) const { gl.Uniform1i(at, x); }
    void operator()(const Float2& x) const { gl.Uniform2fv(at, 1, &x[0]); }
    void operator()(const Float3& x) const { gl.Uniform3fv(at, 1, &x[0]); }
    void operator()(const Float4& x) const { gl.Uniform4fv(at, 1, &x[0]); }
    void operator()(const Float3x3& x) const { gl.UniformMatrix3fv(at, 1, GL_FALSE, &x[0][0]); }
    void operator()(const Float4x4& x) const { gl.UniformMatrix4fv(at, 1, GL_FALSE, &x[0][0]); }
  };
  std::visit(Set{gl, setting.location}, setting.value);
}

} // namespace refraster
