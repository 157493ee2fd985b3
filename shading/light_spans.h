#pragma once
// The lights of a scene as shading takes them.

#include <refraster/scene.h>

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

} // namespace refraster
