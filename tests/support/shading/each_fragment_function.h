#pragma once
// One of every fragment function, for tests that must name the ones that something lacks.

#include <refraster/material.h>

#include <cstddef>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace refraster {

/// In the order of the list, with the parameters that each has from the start.
inline std::vector<FragmentFunction> each_fragment_function() {
  return []<std::size_t... I>(std::index_sequence<I...>) {
    return std::vector<FragmentFunction>{FragmentFunction(std::in_place_index<I>)...};
  }
  (std::make_index_sequence<std::variant_size_v<FragmentFunction>>{});
}

/// Whether a texture belongs to microfacets alone.
inline bool is_of_microfacets(const TextureSlot& slot) {
  return slot.map == &Material::roughness_map || slot.map == &Material::metallic_map;
}

/// The word of a scene file.
inline std::string_view name_of(const FragmentFunction& function) {
  return std::visit([](const auto& one) { return std::string_view(one.name); }, function);
}

} // namespace refraster
