#pragma once
// Light sources, and what arrives of them at a fragment.

#include <refraster/scene.h>

#include "math/lanes/lane_bits.h"
#include "shading/fragment.h"

#include <limits>

namespace refraster::inline REFRASTER_KIT {

/// A DirectionLight, with the unit vector toward it.
struct DirectionToLight {
  Double3 direction;
  Double3 radiance;
};

/// Whether the same radiance arrives of such a light everywhere.
template <class Light>
inline constexpr bool shines_evenly = false;
template <>
inline constexpr bool shines_evenly<DirectionToLight> = true;

/// What is the same for all fragments is computed once: the light as arriving() takes it. Most are taken as they are.
template <class Light>
Light prepared_light(const Light& light) {
  return light;
}
inline DirectionToLight prepared_light(const DirectionLight& light) {
  return {-normalize(light.direction), light.radiance};
}

/// The same light for a formula that knows of no exception.
template <class Light>
Light textbook_light(const Light& light) {
  return light;
}
inline PointLight textbook_light(PointLight light) {
  const bool attenuated = light.constant > 0 || light.linear > 0 || light.quadratic > 0;
  if (!attenuated) light.constant = 1, light.linear = 0, light.quadratic = 0; // all 0 means none
  return light;
}

/// A light as the numbers of a precision can hold it.
template <class T, class Light>
  requires requires {
    Light::names;
  }
Light within_range(const Light& light) {
  Light result = light;
  Light::fields(result, [](auto&&, auto& value, auto&&...) {
    if constexpr (requires { value = within_range<T>(value); }) value = within_range<T>(value);
  });
  return result;
}
template <class T>
DirectionToLight within_range(const DirectionToLight& light) {
  return {light.direction, within_range<T>(light.radiance)};
}

/// The same light for lanes of T: attenuation that is the same everywhere is in its radiance.
template <class T, class Light>
Light evenly_attenuated(const Light& light) {
  return light;
}
template <Lanes T>
PointLight evenly_attenuated(PointLight light) {
  using F = RealOf<T>;
  if (!(light.constant > 0) || light.linear != 0 || light.quadratic != 0) return light;
  const F factor = F(1) / max(as<F>(light.constant), smallest_normal<F>());
  const auto attenuated = [&](double radiance) {
    return static_cast<double>(min(as<F>(radiance) * factor, largest_number<F>()));
  };
  light.radiance = {attenuated(light.radiance.x), attenuated(light.radiance.y), attenuated(light.radiance.z)};
  light.constant = 0; // all 0 means none
  return light;
}

/// C = radiance times 1 / (Kc + Kl d + Kq d^2), at most the largest finite number: d may be so small that nothing is
/// left of the divisor. With d = 0 no direction is defined and nothing arrives.
template <class T>
Incident<T> arriving(const PointLight& light, const Fragment<T>& at) {
  const Vec3<T> way = as<T>(light.position) - at.position;
  const LengthAndDirection<T> to_light = length_and_direction(way);
  const T d = to_light.length;
  at.undefined(Undefined::light_at_surface, d <= T(0));
  const bool attenuated = light.constant > 0 || light.linear > 0 || light.quadratic > 0;
  T factor(1);
  if (attenuated) {
    // By Horner's rule: where d d overflows, a coefficient of 0 must not meet infinity. Nor where d overflows.
    const T far = min(d, largest_number<T>());
    const T divisor = as<T>(light.constant) + far * (as<T>(light.linear) + far * as<T>(light.quadratic));
    factor = T(1) / max(divisor, smallest_normal<T>());
  }
  const auto channel = [&](double radiance) {
    T c = as<T>(radiance);
    if (attenuated) c = min(c * factor, largest_number<T>());
    return select(d > T(0), c, T(0));
  };
  return {copied(to_light.direction),
          {channel(light.radiance.x), channel(light.radiance.y), channel(light.radiance.z)}};
}

/// C = radiance.
template <class T>
Incident<T> arriving(const DirectionToLight& light, const Fragment<T>&) {
  return {as<T>(light.direction), as<T>(light.radiance)};
}
template <class T>
Incident<T> arriving(const DirectionLight& light, const Fragment<T>& at) {
  return arriving(prepared_light(light), at);
}

} // namespace refraster::inline REFRASTER_KIT
