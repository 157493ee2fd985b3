#pragma once
// Light sources, and what arrives of them at a fragment.

#include <refraster/scene.h>

#include "shading/fragment.h"

#include <limits>

namespace refraster::inline REFRASTER_KIT {

/// A DirectionLight, with the unit vector toward it.
struct DirectionToLight {
  Double3 direction;
  Double3 radiance;
};

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

/// C = radiance times 1 / (Kc + Kl d + Kq d^2), at most the largest finite number: d may be so small that nothing is
/// left of the divisor. With d = 0 no direction is defined and nothing arrives.
template <class T>
Incident<T> arriving(const PointLight& light, const Fragment<T>& at) {
  const Vec3<T> way = as<T>(light.position) - at.position;
  const T d = length(way);
  at.undefined(Undefined::light_at_surface, d <= T(0));
  const bool attenuated = light.constant > 0 || light.linear > 0 || light.quadratic > 0;
  Rgb<T> radiance = as<T>(light.radiance);
  if (attenuated) {
    // By Horner's rule: where d d overflows, a coefficient of 0 must not meet infinity. Nor where d overflows.
    const T largest = largest_number<T>(), far = min(d, largest);
    const T divisor = as<T>(light.constant) + far * (as<T>(light.linear) + far * as<T>(light.quadratic));
    radiance *= T(1) / max(divisor, smallest_normal<T>());
    radiance = {min(radiance.x, largest), min(radiance.y, largest), min(radiance.z, largest)};
  }
  return {normalize(way), select<T>(d > T(0), radiance, Rgb<T>(T(0)))};
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
