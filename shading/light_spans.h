#pragma once
// The lights of a scene as shading takes them.

#include <refraster/scene.h>

#include <cstddef>
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

/// What a number that does not decide may see of a light: from `lo` to `hi`, 0 to 1.
struct VisibilityRange {
  double lo = 0, hi = 1;
};

/// Of each light with a shadow, in the order of the sum, a row; in it a number for each fragment: 1 where it sees the
/// light, 0 where not, and with a filtered map what lies between. A few more than there are fragments may be read, as
/// many as a register has lanes. For numbers that do not decide, a range for each light instead, of one fragment.
struct LightVisibility {
  const double* rows = nullptr;            // of the first such light; null: not known
  std::size_t stride = 0;                  // from one light's row to the next
  const VisibilityRange* ranges = nullptr; // of the first such light; null: anything

  /// The same from fragment `first` on.
  LightVisibility from(std::size_t first) const { return {rows ? rows + first : nullptr, stride, ranges}; }
  /// The same from the next light with a shadow on.
  LightVisibility next_light() const { return {rows ? rows + stride : nullptr, stride, ranges ? ranges + 1 : nullptr}; }
};

} // namespace refraster
