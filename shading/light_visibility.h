#pragma once
// What lights with shadows a fragment sees. Decided once for all numbers, as which triangle a sample sees is, and given
// to shading: a factor of what arrives, of which fragment functions know nothing.

#include <refraster/scene.h>

#include "math/number.h"
#include "math/vec.h"
#include "shading/light_spans.h"

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace refraster::inline REFRASTER_KIT {

/// One light's.
struct LightShadow {
  Shadow kind = Shadow::none;
  const std::uint8_t* row = nullptr; // null: not known
};

/// Gives lights their rows, one after the other.
class ShadowRows {
public:
  explicit ShadowRows(const LightVisibility& of) : next_(of) {}

  LightShadow of(const auto& light) {
    if (light.shadow == Shadow::none) return {};
    const LightShadow shadow{light.shadow, next_.rows};
    next_ = next_.from(next_.stride);
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

/// C, from radiance times attenuation: 0 where the fragments that T stands for, from number `first` on, do not see the
/// light, whose shadow takes_light(). In a number that does not decide, either.
template <class T>
Rgb<T> times_visibility(const Rgb<T>& radiance, const LightShadow& shadow, std::size_t first) {
  if constexpr (!NumberTraits<T>::decides) {
    const T none(0);
    return {join(none, radiance.x), join(none, radiance.y), join(none, radiance.z)};
  } else if constexpr (NumberTraits<T>::has_lanes) {
    VectorOf<std::uint8_t, NumberTraits<T>::lanes> bytes;
    std::memcpy(&bytes, shadow.row + first, sizeof bytes);
    const T visibility(__builtin_convertvector(bytes, typename T::Lanes));
    return radiance * visibility;
  } else {
    return shadow.row[first] ? radiance : Rgb<T>(T(0));
  }
}

} // namespace refraster::inline REFRASTER_KIT
