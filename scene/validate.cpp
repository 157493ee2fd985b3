#include <refraster/scene.h>

#include "scene/scene_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <unordered_set>

namespace refraster {
namespace {

/// Parameters and sizes, which are few; or every value of meshes and textures too.
enum class Depth { parameters, values };

std::string text_of(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", x);
  return text;
}
std::string text_of(const Double3& a) {
  return text_of(a.x) + ", " + text_of(a.y) + ", " + text_of(a.z);
}
std::string text_of(std::size_t count, std::string_view what) {
  return std::to_string(count) + " " + std::string(what);
}

std::string expected_of(const Range& range) {
  const bool all = range.min == any_number.min && range.max == any_number.max;
  if (all) return "finite numbers";
  const bool open = range.ends == Ends::excluded;
  std::string text = (open ? "above " : "from ") + text_of(range.min);
  if (range.max < any_number.max) text += (open ? " and below " : " to ") + text_of(range.max);
  return "finite numbers " + text;
}

bool finite(const Double3& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}
bool is_zero(const Double3& a) {
  return a.x == 0 && a.y == 0 && a.z == 0;
}

/// Goes through a scene and tells each fault to `found`.
class Checker {
public:
  Checker(Depth depth, std::function<void(SceneFault)> found) : depth_(depth), found_(std::move(found)) {}

  void check(const Scene& scene) {
    check(scene.camera);
    field([] { return ""; }, "background", scene.background, Range{});
    for_each_light_list(scene, [&]<class Light>(const std::vector<Light>& lights) {
      for (std::size_t i = 0; i < lights.size(); ++i) check_light(lights[i], item(Light::names.key.data(), i));
    });
    for (std::size_t i = 0; i < scene.objects.size(); ++i) check(scene.objects[i], i);
  }

private:
  using Effect = SceneFault::Effect;
  /// Made only where there is something to tell.
  using Where = std::function<std::string()>;

  static Where item(const char* list, std::size_t index) {
    return [=] { return list + ('/' + std::to_string(index) + '/'); };
  }

  void fault(std::string where, std::string found, std::string expected, Effect effect = Effect::refused) {
    found_({effect, std::move(where), std::move(found), std::move(expected)});
  }

  /// Formulas are total, so that what is finite can be drawn; what it looks like out of its range is not promised.
  void field(const Where& owner, const char* name, double value, const Range& range) {
    if (range.contains(value)) return;
    fault(owner() + name, text_of(value), expected_of(range), std::isfinite(value) ? Effect::drawn : Effect::refused);
  }
  void field(const Where& owner, const char* name, const Double3& value, const Range& range) {
    if (range.zero == Zero::excluded && is_zero(value)) fault(owner() + name, text_of(value), "a direction");
    if (range.contains(value.x) && range.contains(value.y) && range.contains(value.z)) return;
    fault(owner() + name, text_of(value), expected_of(range), finite(value) ? Effect::drawn : Effect::refused);
  }

  /// Without it there is no view.
  void need(double value, const Range& range, const char* where) {
    if (!range.contains(value)) fault(where, text_of(value), expected_of(range));
  }

  void check(const Camera& camera) {
    const Where at = [] { return "camera/"; };
    field(at, "position", camera.position, any_number);
    field(at, "target", camera.target, any_number);
    field(at, "up", camera.up, any_number);
    need(camera.fov_y_degrees, {0, 180, Ends::excluded}, "camera/fov_y");
    need(camera.near, {.ends = Ends::excluded}, "camera/near");
    need(camera.far, {.ends = Ends::excluded}, "camera/far");
    if (camera.far <= camera.near) fault("camera/far", text_of(camera.far), "more than near, " + text_of(camera.near));
    if (camera.target == camera.position) fault("camera/target", text_of(camera.target), "another point than position");
    if (is_zero(camera.up)) fault("camera/up", text_of(camera.up), "a direction");
  }

  template <class Light>
  void check_light(const Light& light, const Where& at) {
    Light::fields(light, [&](const char* name, const auto& value, const Range& range, auto&&) {
      if constexpr (std::is_same_v<decltype(value), const CastShadow&>) check(value, at);
      else if constexpr (requires { field(at, name, value, range); }) field(at, name, value, range);
    });
  }

  void check(const CastShadow& shadow, const Where& light) {
    if (shadow != Shadow::map) return;
    const Where at = [&] { return light() + "shadow/"; };
    ShadowMap::fields(shadow.map, [&]<class Value>(const char* name, const Value& value, const Range& range, auto&&) {
      if constexpr (std::is_same_v<Value, int>) need(value, range, (at() + name).c_str()); // memory is taken for it
      else if constexpr (std::is_same_v<Value, double>) field(at, name, value, range);
    });
  }

  void check(const Object& object, std::size_t index) {
    const Where at = item("objects", index);
    field(at, "position", object.position, any_number);
    field(at, "rotate_x", object.rotate_degrees.x, any_number);
    field(at, "rotate_y", object.rotate_degrees.y, any_number);
    field(at, "rotate_z", object.rotate_degrees.z, any_number);
    field(at, "scale", object.scale, any_number);
    if (!object.mesh) fault(at() + "mesh", "null", "a mesh");
    else if (meshes_.insert(object.mesh.get()).second) check(*object.mesh, at);
    check(object.material, [&] { return at() + "material/"; });
    for (std::size_t i = 0; i < object.materials.size(); ++i)
      check(object.materials[i], [&] { return at() + "materials/" + std::to_string(i) + '/'; });
  }

  void check(const Mesh& mesh, const Where& object) {
    const std::size_t count = mesh.positions.size();
    const Where at = [&] { return object() + "mesh/"; };
    for_each_vertex_attribute([&](const auto& attribute) {
      const std::size_t values = (mesh.*attribute.values).size();
      if (attribute.need == Need::required && values != count)
        fault(at() + std::string(attribute.name), text_of(values, attribute.words),
              text_of(count, attribute.words) + ": one a position");
      else if (values > count)
        fault(at() + std::string(attribute.name), text_of(values, attribute.words),
              "at most one a position: " + text_of(count, "of them"));
    });
    for (std::size_t i = 1; i < mesh.material_runs.size(); ++i)
      if (mesh.material_runs[i].first_triangle <= mesh.material_runs[i - 1].first_triangle) {
        fault(at() + "material_runs/" + std::to_string(i),
              "first triangle " + std::to_string(mesh.material_runs[i].first_triangle),
              "more than " + std::to_string(mesh.material_runs[i - 1].first_triangle) + ", that of the run before");
        break;
      }
    if (depth_ == Depth::parameters) return;
    check_indices(mesh, at);
    for_each_vertex_attribute(
        [&](const auto& attribute) { check_finite(mesh.*attribute.values, at, std::string(attribute.name) + '/'); });
  }

  void check_indices(const Mesh& mesh, const Where& at) {
    if (indices_within(mesh.triangles, mesh.positions.size())) return;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      for (const std::uint32_t vertex : mesh.triangles[i])
        if (vertex >= mesh.positions.size())
          return fault(at() + "triangles/" + std::to_string(i), "vertex " + std::to_string(vertex),
                       "an index below " + text_of(mesh.positions.size(), "vertices"));
  }

  template <class Vector>
  void check_finite(const std::vector<Vector>& list, const Where& at, const std::string& name) {
    for (std::size_t i = 0; i < list.size(); ++i)
      for (glm::length_t c = 0; c < Vector::length(); ++c)
        if (!std::isfinite(list[i][c]))
          return fault(at() + name + std::to_string(i), text_of(static_cast<double>(list[i][c])), "finite numbers",
                       Effect::drawn);
  }

  void check(const Material& material, const Where& at) {
    if (material.user_function) {
      if (functions_.insert(material.user_function.get()).second) {
        ParameterChecker parameters(*this, at);
        material.user_function->copy()->fields(parameters);
      }
    } else {
      std::visit([&](const auto& function) { check_parameters(function, at); }, material.fragment_function);
    }
    field(at, "emissive", material.emissive, Range{});
    field(at, "opacity_threshold", material.opacity_threshold, Range{0, 1});
    field(at, "normal_scale", material.normal_scale, any_number);
    field(at, "bump_scale", material.bump_scale, any_number);
    for (const TextureSlot& slot : texture_slots) {
      const TextureMap& map = material.*slot.map;
      const Texture* const texture = map.texture.get();
      if (!texture) continue;
      const Where at_texture = [&] { return at() + std::string(slot.name); };
      for (const Double2& placed : {map.scale, map.offset})
        if (!std::isfinite(placed.x) || !std::isfinite(placed.y))
          fault(at_texture(), "a scale or offset that is not finite", "finite numbers");
      if (textures_.insert(texture).second) check(*texture, at_texture);
      const std::vector<TextureLevel>& levels = texture->levels;
      if (map.filter == TextureFilter::trilinear && !levels.empty() &&
          (levels.back().width > 1 || levels.back().height > 1))
        fault(at_texture(), text_of(levels.size(), "levels"), "levels down to 1 x 1 texel, for trilinear filtering",
              Effect::drawn);
    }
  }

  template <class Function>
  void check_parameters(const Function& function, const Where& at) {
    Function::fields(function, [&](std::string_view name, const auto& value, const Range& range, std::string_view) {
      if constexpr (requires { field(at, "", value, range); }) field(at, std::string(name).c_str(), value, range);
    });
    if constexpr (requires { function.table; })
      if (!function.table) fault(at() + "table", "null", "a measured table");
  }

  struct ParameterChecker final : FieldVisitor {
    ParameterChecker(Checker& its_checker, const Where& its_owner) : checker(its_checker), at(its_owner) {}
    void field(std::string_view name, double& value, const Range& range, std::string_view) override {
      checker.field(at, std::string(name).c_str(), value, range);
    }
    void field(std::string_view name, Double3& value, const Range& range, std::string_view) override {
      checker.field(at, std::string(name).c_str(), value, range);
    }
    void field(std::string_view, NamedValue&, const Range&, std::string_view) override {}
    Checker& checker;
    const Where& at;
  };

  void check(const Texture& texture, const Where& at_texture) {
    const Where at = [&] { return at_texture() + '/'; };
    field(at, "full_scale", texture.full_scale, {.ends = Ends::excluded});
    if (texture.levels.empty()) fault(at() + "levels", "no level", "at least one");
    for (std::size_t k = 0; k < texture.levels.size(); ++k) {
      const TextureLevel& level = texture.levels[k];
      const Where at_level = [&] { return at() + "levels/" + std::to_string(k); };
      if (level.width < 1 || level.height < 1 || level.width > 65536 || level.height > 65536) {
        fault(at_level(), std::to_string(level.width) + " x " + std::to_string(level.height) + " texels",
              "1 to 65536 texels a side");
        return;
      }
      if (k > 0) check_halved(texture.levels[k - 1], level, at_level);
      const std::size_t values = 3 * static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height);
      if (level.rgb.size() != values)
        fault(at_level(), text_of(level.rgb.size(), "values"), text_of(values, "values: three a texel"));
      if (depth_ == Depth::parameters) continue;
      const auto wrong = std::find_if_not(level.rgb.begin(), level.rgb.end(), [&](float value) {
        return value >= 0 && static_cast<double>(value) <= texture.full_scale;
      });
      if (wrong != level.rgb.end())
        fault(at_level() + "/" + std::to_string(wrong - level.rgb.begin()), text_of(static_cast<double>(*wrong)),
              "a number from 0 to " + text_of(texture.full_scale), Effect::drawn);
    }
  }

  void check_halved(const TextureLevel& below, const TextureLevel& level, const Where& at) {
    if (level.width != std::max(1, below.width / 2) || level.height != std::max(1, below.height / 2))
      fault(at(), std::to_string(level.width) + " x " + std::to_string(level.height) + " texels",
            "half of the level below, " + std::to_string(below.width) + " x " + std::to_string(below.height));
  }

  Depth depth_;
  std::function<void(SceneFault)> found_;
  std::unordered_set<const void*> meshes_, textures_, functions_; // those that were looked at
};

} // namespace

std::string SceneFault::text() const {
  return where + ": found " + found + ", expected " + expected;
}

std::vector<SceneFault> validate(const Scene& scene) {
  std::vector<SceneFault> faults;
  Checker(Depth::values, [&](SceneFault fault) { faults.push_back(std::move(fault)); }).check(scene);
  return faults;
}

std::optional<SceneFault> first_refused_fault(const Scene& scene) {
  std::optional<SceneFault> first;
  Checker(Depth::parameters, [&](SceneFault fault) {
    if (!first && fault.effect == SceneFault::Effect::refused) first = std::move(fault);
  }).check(scene);
  return first;
}

bool indices_within(std::span<const std::array<std::uint32_t, 3>> triangles, std::size_t vertices) {
  std::uint32_t greatest = 0;
  for (const auto& triangle : triangles)
    greatest = std::max(greatest, std::max(triangle[0], std::max(triangle[1], triangle[2])));
  return triangles.empty() || greatest < vertices;
}

void refuse_indices(const Scene& scene) {
  for (const SceneFault& fault : validate(scene))
    if (fault.effect == SceneFault::Effect::refused) refuse(fault);
}

void refuse(const SceneFault& fault) {
  throw std::invalid_argument(fault.text());
}

} // namespace refraster
