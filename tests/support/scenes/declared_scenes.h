#pragma once
// A scene for each entry of the declared lists: types of light, texture slots and optional vertex attributes.

#include <refraster/mesh.h>
#include <refraster/scene.h>

#include "tests/support/scenes/half_textured.h"

#include <algorithm>
#include <string>
#include <vector>

namespace refraster {

/// What an entry is called, and a scene that has it and one that lacks only it.
struct DeclaredEntry {
  std::string name;
  Scene with, without;
};

namespace declared_detail {

inline void change_mesh(Scene& scene, auto&& change) {
  Mesh mesh = *scene.objects[0].mesh;
  change(mesh);
  scene.objects[0].mesh = std::make_shared<const Mesh>(std::move(mesh));
}

/// A light of any type that shines on the origin from the camera's side, more or less.
template <class Light>
Light some_light() {
  Light light;
  if constexpr (requires { light.position; }) light.position = {2, 3, 5};
  if constexpr (requires { light.direction; }) light.direction = {-2, -3, -5};
  light.radiance = {0.5, 0.6, 0.7};
  return light;
}

inline std::shared_ptr<const Texture> some_texture(std::size_t number) {
  auto texture = std::make_shared<Texture>();
  TextureLevel image{4, 4, {}};
  for (std::size_t i = 0; i < 48; ++i) image.rgb.push_back(static_cast<float>((i + 1) * (71 + 2 * number) % 200 + 20));
  texture->levels.push_back(std::move(image));
  return texture;
}

} // namespace declared_detail

inline std::vector<DeclaredEntry> declared_entries() {
  using namespace declared_detail;
  std::vector<DeclaredEntry> entries;
  Scene plain = half_textured(TextureFilter::bilinear);
  plain.objects[0].material.diffuse_map.texture = nullptr;
  change_mesh(plain, [](Mesh& mesh) { mesh.uvs.resize(mesh.positions.size(), Float2(0.3f, 0.6f)); });

  for_each_light_list(plain, [&]<class Light>(std::vector<Light>& lights) {
    DeclaredEntry entry{std::string(Light::names.words), plain, plain};
    for_each_light_list(entry.with, [&](auto& all) {
      if constexpr (requires { all = lights; }) all = {some_light<Light>(), some_light<Light>()};
      else all.clear();
    });
    entry.with.objects[0].material.diffuse_map.texture = nullptr;
    for_each_light_list(entry.without, [](auto& all) { all.clear(); });
    entries.push_back(std::move(entry));
  });
  for (std::size_t i = 0; i < texture_slots.size(); ++i) {
    const TextureSlot& slot = texture_slots[i];
    DeclaredEntry entry{"the texture " + std::string(slot.name), plain, plain};
    for (Scene* const scene : {&entry.with, &entry.without})
      change_mesh(*scene, [](Mesh& mesh) {
        for (std::size_t v = 0; v < mesh.uvs.size(); ++v) mesh.uvs[v] = Float2(mesh.positions[v]);
      });
    for (Scene* const scene : {&entry.with, &entry.without})
      if (Material& material = scene->objects[0].material; !shows(material, slot)) {
        Microfacet function;
        function.base_color = {0.8, 0.6, 0.5}, function.metallic = function.roughness = 0.7;
        material.fragment_function = function;
      }
    if (slot.use == SlotUse::surface)
      for (Scene* const scene : {&entry.with, &entry.without})
        change_mesh(*scene, [](Mesh& mesh) { add_tangents(mesh); });
    for (Scene* const scene : {&entry.with, &entry.without})
      if (slot.multiplied) scene->objects[0].material.*slot.multiplied = Double3(1);
    (entry.with.objects[0].material.*slot.map).texture = some_texture(i);
    entries.push_back(std::move(entry));
  }
  for_each_vertex_attribute([&]<class Value>(const VertexAttribute<Value>& attribute) {
    if (attribute.need == Need::required) return;
    DeclaredEntry entry{std::string(attribute.words), plain, plain};
    for (Scene* const scene : {&entry.with, &entry.without}) {
      for (std::size_t i = 0; i < texture_slots.size(); ++i)
        (scene->objects[0].material.*texture_slots[i].map).texture = some_texture(i);
      change_mesh(*scene, [&](Mesh& mesh) { (mesh.*attribute.values).clear(); });
    }
    change_mesh(entry.with, [&](Mesh& mesh) { // of half of the vertices, as an optional attribute may be
      for (std::size_t v = 0; v < mesh.positions.size() / 2; ++v) {
        Value value;
        for (glm::length_t c = 0; c < Value::length(); ++c)
          value[c] = 0.25f + 0.5f * static_cast<float>((v / 5 + static_cast<std::size_t>(c)) % 7) / 7;
        (mesh.*attribute.values).push_back(value);
      }
    });
    entries.push_back(std::move(entry));
  });
  return entries;
}

} // namespace refraster
