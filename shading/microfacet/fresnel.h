#pragma once
// How much of the light that meets a smooth boundary is reflected, by its angle of incidence, unpolarised: 0 to 1.

#include "math/vec.h"

namespace refraster::inline REFRASTER_KIT {

/// The angle of incidence. Both in [0, 1]; given apart, so that neither comes from the other by a difference from 1.
template <class T>
struct Incidence {
  T cosine, squared_sine;
};

/// (1 - c)^5, with 1 - c = s^2 / (1 + c): it is never negative, so there is nothing to clamp.
template <Number T>
T schlick_weight(const Incidence<T>& at) {
  const T away = at.squared_sine / (T(1) + at.cosine);
  return square(square(away)) * away;
}

/// f0 + (1 - f0) (1 - c)^5, f0 being the reflectance at normal incidence. Schlick, "An inexpensive BRDF model for
/// physically-based rendering", 1994.
template <Number T>
Rgb<T> schlick_reflectance(const Rgb<T>& f0, const T& weight) {
  return f0 + (Rgb<T>(T(1)) - f0) * weight;
}

/// 1 - (1 - c)^5, the factor of 1 - f0 in what Schlick's formula lets through: c (1 + y + y^2 + y^3 + y^4), y = 1 - c.
template <Number T>
T schlick_transmitted_weight(const T& c) {
  const T y = T(1) - c;
  return c * (T(1) + y * (T(1) + y * (T(1) + y * (T(1) + y))));
}

/// Of a dielectric, at cosine c of the angle of incidence; `excess` is the square of its refractive index less 1, >= 0.
/// Undefined where both are 0. Walter et al., "Microfacet models for refraction through rough surfaces", 2007,
/// equation 22.
template <Number T>
T dielectric_reflectance(const T& c, const T& excess) {
  const T g = sqrt(excess + square(c));
  return as<T>(0.5) * square((g - c) / (g + c)) * (T(1) + square((c * (g + c) - T(1)) / (c * (g - c) + T(1))));
}

/// 1 less that: what enters. Of each polarisation it is a product, 4 c g / (c + g)^2 and, with i = excess + 1,
/// 4 i c g / (i c + g)^2, so that little of it is as exact as much.
template <Number T>
T dielectric_transmittance(const T& c, const T& excess) {
  const T i = excess + T(1), g = sqrt(excess + square(c));
  const T across = T(1) / (c + g), along = T(1) / (i * c + g);
  return min(T(2) * c * g * (square(across) + i * square(along)), T(1));
}

/// Of a conductor with refractive index eta + i k, eta > 0, k >= 0. With a^2 - b^2 = eta^2 - k^2 - s^2 and a b = eta k:
///     Fs = ((a - c)^2 + b^2) / ((a + c)^2 + b^2),
///     Fp = Fs ((a c - s^2)^2 + b^2 c^2) / ((a c + s^2)^2 + b^2 c^2).
/// a^2 and b^2 are (|p + i q| +- p) / 2: the larger is computed so, the other from their product, as p may be nearly as
/// large as its sum with q. Born, Wolf, "Principles of optics", section 14.2.
template <Number T>
T conductor_reflectance(const Incidence<T>& at, const T& eta, const T& k) {
  const T c = at.cosine, s_2 = at.squared_sine;
  const T p = (eta - k) * (eta + k) - s_2, half_q = square(eta * k);
  const T larger = as<T>(0.5) * (sqrt(square(p) + T(4) * half_q) + abs(p));
  const T smaller = half_q / select(larger > T(0), larger, T(1));
  const T a = sqrt(select(p >= T(0), larger, smaller)), b_2 = select(p >= T(0), smaller, larger);
  const T across = min((square(a - c) + b_2) / (square(a + c) + b_2), T(1));
  const T b_2_c_2 = b_2 * square(c), a_c = a * c;
  const T along = min((square(a_c - s_2) + b_2_c_2) / (square(a_c + s_2) + b_2_c_2), T(1)); // 1 for 0 / 0
  return as<T>(0.5) * across * (T(1) + along);
}

} // namespace refraster::inline REFRASTER_KIT
