#include "bench/workloads/variants.h"

#include <algorithm>

namespace refraster::bench {
namespace {

bool shows_texture(const Material& material) {
  return !material.measured();
}

/// 64 x 64 texels in smooth colours, 48 kB: stays in the first caches, so that sampling is paid for and not memory.
std::shared_ptr<const Texture> small_texture() {
  constexpr int side = 64;
  TextureLevel level{side, side, {}};
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (const int value : {4 * x, 4 * y, 255 - 2 * x - 2 * y}) level.rgb.push_back(static_cast<float>(value));
  return std::make_shared<Texture>(Texture{255, {std::move(level)}});
}

} // namespace

Scene without_lights(Scene scene) {
  for_each_light_list(scene, [](auto& lights) { lights.clear(); });
  return scene;
}

Scene with_one_more_light(Scene scene) {
  if (lights(scene) == 0) {
    scene.point_lights.push_back({.position = scene.camera.position});
    return scene;
  }
  std::size_t of_later_types = lights(scene);
  for_each_light_list(scene, [&](auto& list) {
    of_later_types -= list.size();
    if (!list.empty() && of_later_types == 0) list.push_back(list.back());
  });
  return scene;
}

std::size_t lights(const Scene& scene) {
  return light_count(scene);
}

Scene without_textures(Scene scene) {
  for_each_material(scene, [](Material& material) {
    if (shows_texture(material))
      for (const TextureSlot& slot : texture_slots) (material.*slot.map).texture = nullptr;
  });
  return scene;
}

Scene with_textures(Scene scene) {
  const std::shared_ptr<const Texture> texture = small_texture();
  for_each_material(scene, [&](Material& material) {
    if (!shows_texture(material)) return;
    material.diffuse_map = {.texture = texture};
  });
  return scene;
}

bool has_textures(const Scene& scene) {
  return any_material(scene, [](const Material& material) { return shows_texture(material) && is_textured(material); });
}

bool shows_textures(const Scene& scene) {
  return any_material(scene, shows_texture);
}

std::string name_of(const FragmentFunctionVariant& function) {
  std::string name(function.name);
  if (function.lookup) name.append(" ").append(refraster::name_of(*function.lookup));
  return name;
}

std::vector<FragmentFunctionVariant> functions_of(const Scene& scene) {
  std::vector<FragmentFunctionVariant> functions;
  const auto add = [&](const FragmentFunctionVariant& function) {
    if (std::find(functions.begin(), functions.end(), function) == functions.end()) functions.push_back(function);
  };
  for_each_material(scene, [&](const Material& material) {
    if (const Merl* const merl = material.measured())
      for (const MerlLookup lookup : {merl->lookup, MerlLookup::nearest, MerlLookup::trilinear})
        add({Merl::name, lookup});
    else add({material.function_name(), std::nullopt});
  });
  return functions;
}

Scene only(Scene scene, const FragmentFunctionVariant& function) {
  const auto has_it = [&](const Material& material) { return material.function_name() == function.name; };
  for (Object& object : scene.objects) {
    if (object.materials.empty()) continue;
    auto part = std::make_shared<Mesh>(*object.mesh); // without the triangles of other functions
    part->triangles.clear();
    part->material_runs.clear();
    const auto triangles = static_cast<std::uint32_t>(object.mesh->triangles.size());
    for (std::uint32_t begin = 0; begin < triangles;) {
      const MaterialRange range = material_range(object, begin);
      const std::uint32_t from = begin;
      begin = range.end_triangle;
      if (!has_it(*range.material)) continue;
      const bool named = range.material != &object.material;
      part->material_runs.push_back(
          {static_cast<std::uint32_t>(part->triangles.size()),
           named ? static_cast<std::uint32_t>(range.material - object.materials.data()) : no_material});
      part->triangles.insert(part->triangles.end(), object.mesh->triangles.begin() + from,
                             object.mesh->triangles.begin() + range.end_triangle);
    }
    object.mesh = std::move(part);
  }
  std::erase_if(scene.objects, [&](const Object& object) {
    return object.materials.empty() ? !has_it(object.material) : object.mesh->triangles.empty();
  });
  for_each_material(scene, [&](Material& material) {
    if (Merl* const merl = std::get_if<Merl>(&material.fragment_function); merl && has_it(material))
      merl->lookup = function.lookup.value();
  });
  return scene;
}

} // namespace refraster::bench
