#pragma once
// Textures, fragment functions and materials, as Python has them: objects that others refer to. scenes.cpp makes a
// Scene of them.

#include <refraster/material.h>
#include <refraster/texture.h>

#include "python/fields.h"

#include <array>
#include <memory>
#include <type_traits>

namespace refraster::python {

/// refraster.Texture
struct LiveTexture {
  std::shared_ptr<const Texture> texture;          ///< not null
  std::shared_ptr<const Texture> with_levels = {}; ///< the same with all smaller levels, once somebody asked

  /// What a filter reads: all levels for trilinear.
  std::shared_ptr<const Texture> for_filter(TextureFilter filter);
};

/// refraster.TextureMap
struct LiveTextureMap {
  std::shared_ptr<LiveTexture> texture;
  MapText text; ///< of it, how the texture is read

  static void fields(auto& self, const auto& use) {
    map_keys(self.text, ValueKeys{[&]<class Value>(std::string_view name, Value& value, const Range& range,
                                                   std::string_view meaning) {
               if constexpr (!std::is_same_v<Value, ColourSpace>) use(name, value, range, meaning); // of a file
             }});
  }
};

/// refraster.Material
struct LiveMaterial {
  py::object function;                                                    ///< one of FragmentFunction
  std::array<std::shared_ptr<LiveTextureMap>, texture_slots.size()> maps; ///< in the order of the slots; may be null
  ObjectText text;                                                        ///< of it, all else that a material has

  static void fields(auto& self, const auto& use) {
    material_keys(self.text, ValueKeys{[&]<class Value>(std::string_view name, Value& value, const Range& range,
                                                        std::string_view meaning) {
                    if constexpr (!NamedEnum<Value>) use(name, value, range, meaning); // filters are the maps'
                  }});
  }

  /// As the library has it. Throws ArgumentError, with `place`, if there is no function.
  Material material(const std::string& place) const;
};

/// The Python object that holds a copy of a fragment function.
py::object live_function(const FragmentFunction& function);

/// A texture, a map or None, as a map; null for None. Throws ArgumentError.
std::shared_ptr<LiveTextureMap> map_argument(const std::string& place, py::handle given);

} // namespace refraster::python
