#pragma once
// Lights, and what keeps them from surfaces, as Python has them.

#include <refraster/scene.h>

#include "python/fields.h"

#include <string_view>

namespace refraster::python {

/// refraster.ShadowMap
struct LiveShadowMap {
  ShadowMap map;

  /// A scene file says "map" for the size, since that is what makes an object a map there; here its class does.
  static void fields(auto& self, const auto& use) {
    ShadowMap::fields(self.map, [&](std::string_view name, auto& value, const Range& range, std::string_view meaning) {
      use(name == "map" ? "size" : name, value, range, meaning);
    });
  }
};

/// refraster.PointLight and so on
template <class Light>
struct LiveLight {
  Light light;
  LightSpace space = LightSpace::world;
  static void fields(auto& self, const auto& use) { light_keys(self.light, self.space, ValueKeys{use}); }
};

} // namespace refraster::python
