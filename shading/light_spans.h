#pragma once
// The lights of a scene as shading takes them.

#include <refraster/scene.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace refraster {

/// Every list of lights, in the order of light_lists.
using LightSpans = decltype(std::apply(
    []<class... Light>(std::vector<Light> Scene::*...) { return std::tuple<std::span<const Light>...>{}; },
    light_lists));

/// Of a scene that outlives them.
inline LightSpans light_spans(const Scene& scene) {
  return std::apply([&](auto... list) { return LightSpans{scene.*list...}; }, light_lists);
}

/// Of each light with a shadow, in the order of the sum, a row; in it a byte for each fragment, 1 where it sees the
/// light and 0 where not. A few bytes more than there are fragments may be read, as many as a register has lanes.
struct LightVisibility {
  const std::uint8_t* rows = nullptr; // of the first such light; null: not known
  std::size_t stride = 0;             // from one light's row to the next

  /// The same from fragment `first` on.
  LightVisibility from(std::size_t first) const { return {rows ? rows + first : nullptr, stride}; }
};

} // namespace refraster
