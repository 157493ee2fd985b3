#include "bench/workloads/variants.h"

#include <algorithm>

namespace refraster::bench {
namespace {

bool shows_texture(const Object& object) {
  return !object.material.measured();
}

std::string_view function_name(const Object& object) {
  return object.material.function_name();
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
  for (Object& object : scene.objects)
    if (shows_texture(object))
      for (const TextureSlot& slot : texture_slots) object.material.*slot.texture = nullptr;
  return scene;
}

Scene with_textures(Scene scene) {
  const std::shared_ptr<const Texture> texture = small_texture();
  for (Object& object : scene.objects) {
    if (!shows_texture(object)) continue;
    for (const TextureSlot& slot : texture_slots) {
      object.material.*slot.texture = texture;
      object.material.*slot.filter = TextureFilter::bilinear;
    }
  }
  return scene;
}

bool has_textures(const Scene& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(), [](const Object& object) {
    return shows_texture(object) &&
           std::any_of(texture_slots.begin(), texture_slots.end(),
                       [&](const TextureSlot& slot) { return object.material.*slot.texture != nullptr; });
  });
}

bool shows_textures(const Scene& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(), shows_texture);
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
  for (const Object& object : scene.objects) {
    if (const Merl* const merl = object.material.measured())
      for (const MerlLookup lookup : {merl->lookup, MerlLookup::nearest, MerlLookup::trilinear})
        add({Merl::name, lookup});
    else add({function_name(object), std::nullopt});
  }
  return functions;
}

Scene only(Scene scene, const FragmentFunctionVariant& function) {
  std::erase_if(scene.objects, [&](const Object& object) { return function_name(object) != function.name; });
  for (Object& object : scene.objects)
    if (Merl* const merl = std::get_if<Merl>(&object.material.fragment_function))
      merl->lookup = function.lookup.value();
  return scene;
}

} // namespace refraster::bench
