#pragma once
// What lights with shadows a fragment sees. Decided once for all numbers, as which triangle a sample sees is, and given
// to shading: a factor of what arrives, of which fragment functions know nothing. A map's fraction is a double in every
// precision, rounded to its number.

#include <refraster/scene.h>

#include "math/number.h"
#include "math/vec.h"
#include "shading/light_spans.h"

#include <cstddef>
#include <cstring>

namespace refraster::inline REFRASTER_KIT {

/// One light's.
struct LightShadow {
  Shadow kind = Shadow::none;
  const double* row = nullptr;            // null: not known
  const VisibilityRange* range = nullptr; // of a number that does not decide; null: anything
};

/// Gives lights their rows, one after the other.
class ShadowRows {
public:
  explicit ShadowRows(const LightVisibility& of) : next_(of) {}

  LightShadow of(const auto& light) {
    if (light.shadow == Shadow::none) return {};
    const LightShadow shadow{light.shadow.kind, next_.rows, next_.ranges};
    next_ = next_.next_light();
    return shadow;
  }

private:
  LightVisibility next_;
};

/// Whether what arrives of a light is still to be multiplied: it has a shadow and that is known, or the number is one
/// that does not decide.
template <class T>
bool takes_light(const LightShadow& shadow) {
  return shadow.kind != Shadow::none && (shadow.row || !NumberTraits<T>::decides);
}

/// C, from radiance times attenuation: times what the fragments that T stands for, from number `first` on, see of the
/// light, whose shadow takes_light(). In a number that does not decide, whatever lies in its range.
template <class T>
Rgb<T> times_visibility(const Rgb<T>& radiance, const LightShadow& shadow, std::size_t first) {
  if constexpr (!NumberTraits<T>::decides) {
    const VisibilityRange range = shadow.range ? *shadow.range : VisibilityRange{};
    if (range.lo == 1) return radiance;
    const auto part = [&](const T& of) {
      const auto times = [&](double seen) { return seen == 0 ? T(0) : seen == 1 ? of : of * T(seen); };
      return join(times(range.lo), times(range.hi));
    };
    return {part(radiance.x), part(radiance.y), part(radiance.z)};
  } else if constexpr (NumberTraits<T>::has_lanes) {
    VectorOf<double, NumberTraits<T>::lanes> seen;
    std::memcpy(&seen, shadow.row + first, sizeof seen);
    const T visibility(__builtin_convertvector(seen, typename T::Lanes));
    return radiance * visibility;
  } else {
    const double seen = shadow.row[first];
    return seen == 0 ? Rgb<T>(T(0)) : radiance * T(seen);
  }
}

} // namespace refraster::inline REFRASTER_KIT
