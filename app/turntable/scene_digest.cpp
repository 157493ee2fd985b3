#include "app/turntable/scene_digest.h"

#include "io/file/sha256.h"

#include <set>
#include <string_view>
#include <type_traits>
#include <variant>

namespace refraster {
namespace {

/// Adds values and, in front of each list, its length, so that no two lists can be taken for two others.
class SceneBytes {
public:
  template <class Value>
  void add(const Value& value) {
    static_assert(std::has_unique_object_representations_v<Value> || std::is_floating_point_v<Value>);
    sha256_.add(&value, sizeof value);
  }
  void add(const Double3& value) { add(value.x), add(value.y), add(value.z); }
  void add(std::string_view text) {
    add(text.size());
    sha256_.add(text.data(), text.size());
  }
  /// Of numbers that stand side by side, without a gap.
  template <class List>
  void add_list(const List& list) {
    add(list.size());
    sha256_.add(list.data(), list.size() * sizeof list[0]);
  }

  void add(const Mesh& mesh) {
    for_each_vertex_attribute([&](const auto& attribute) { add_list(mesh.*attribute.values); });
    add_list(mesh.triangles);
    add_list(mesh.material_runs);
  }

  void add(const Texture& texture) {
    add(texture.full_scale);
    add(texture.levels.size());
    if (texture.levels.empty()) return;
    add(texture.levels[0].width), add(texture.levels[0].height); // smaller levels follow from this one
    add_list(texture.levels[0].rgb);
  }

  void add(const Material& material) {
    add(material.fragment_function.index());
    std::visit([&](const auto& function) { add_function(function); }, material.fragment_function);
    for (const TextureSlot& slot : texture_slots) {
      const TextureMap& map = material.*slot.map;
      add(map.texture != nullptr);
      if (map.texture) add(*map.texture);
      add(static_cast<int>(map.filter)), add(static_cast<int>(map.wrap));
      add(map.scale.x), add(map.scale.y), add(map.offset.x), add(map.offset.y);
    }
    add(material.emissive), add(material.opacity_threshold);
    add(material.normal_scale), add(material.bump_scale);
  }

  /// Where it is, as the file says: options change that.
  void add_place(const Object& object) {
    add(object.position), add(object.rotate_degrees), add(object.scale);
    add(static_cast<int>(object.cull)), add(static_cast<int>(object.two_sided));
  }

  template <class Light>
  void add_light(const Light& light) {
    Light::fields(light, [&](std::string_view key, const auto& value, const Range&, std::string_view) {
      add(key);
      add_parameter(value);
    });
  }

  std::string text() { return in_hexadecimal(sha256_.result()); }

private:
  template <class Function>
  void add_function(const Function& function) {
    // As JSON has them: every kind of parameter has a text there.
    Function::fields(function, [&](std::string_view key, const auto& value, const Range&, std::string_view) {
      add(key);
      add_parameter(value);
    });
    if constexpr (requires { function.table; })
      if (function.table)
        for (std::size_t i = 0; i < 3 * MerlTable::samples; ++i) add(function.table->template values<double>()[i]);
  }
  void add_parameter(const Double3& value) { add(value); }
  void add_parameter(const CastShadow& shadow) {
    add(static_cast<int>(shadow.kind));
    ShadowMap::fields(
        shadow.map, [&](std::string_view, const auto& value, const Range&, std::string_view) { add_parameter(value); });
  }
  template <class Value>
    requires(std::is_arithmetic_v<Value> || std::is_enum_v<Value>)
  void add_parameter(Value value) {
    add(static_cast<double>(static_cast<std::conditional_t<std::is_enum_v<Value>, int, Value>>(value)));
  }

  Sha256 sha256_;
};

} // namespace

std::string scene_digest(const std::string& path, const Scene& scene) {
  SceneBytes bytes;
  bytes.add(std::string_view(file_sha256(path)));
  std::set<const Mesh*> meshes; // shared ones once
  for (const Object& object : scene.objects) {
    if (meshes.insert(object.mesh.get()).second) bytes.add(*object.mesh);
    for_each_material(object, [&](const Material& material) { bytes.add(material); });
    bytes.add_place(object);
  }
  bytes.add(scene.background);
  for_each_light_list(scene, [&](const auto& lights) {
    bytes.add(lights.size());
    for (const auto& light : lights) bytes.add_light(light);
  });
  return bytes.text();
}

} // namespace refraster
