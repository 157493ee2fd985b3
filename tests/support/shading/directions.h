#pragma once
// Directions for the tests of measured reflection.

#include "math/vec.h"

#include <numbers>
#include <random>

namespace refraster {

/// A light direction and a view direction above a surface.
struct SurfacePair {
  Double3 n, i, o;
};

inline double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Uniform on the sphere.
inline Double3 random_direction(std::mt19937_64& random) {
  const double z = uniform(random, -1, 1), phi = uniform(random, 0, 2 * std::numbers::pi);
  const double r = std::sqrt(1 - z * z);
  return normalize(Double3(r * std::cos(phi), r * std::sin(phi), z));
}

inline Double3 random_direction_above(const Double3& n, std::mt19937_64& random) {
  const Double3 a = random_direction(random);
  return dot(a, n) < 0 ? -a : a;
}

/// A unit vector at `angle` radians from a, anywhere around it.
inline Double3 turned(const Double3& a, double angle, std::mt19937_64& random) {
  const Double3 aside = normalize(cross(a, random_direction(random)));
  return normalize(a * std::cos(angle) + aside * std::sin(angle));
}

inline Double3 mirrored(const Double3& i, const Double3& h) {
  return normalize(h * (2 * dot(i, h)) - i);
}

/// Between 10^from and 10^to, uniform in the logarithm.
inline double random_scale(std::mt19937_64& random, double from, double to) {
  return std::pow(10.0, uniform(random, from, to));
}

inline SurfacePair random_pair(std::mt19937_64& random) {
  const Double3 n = random_direction(random);
  return {n, random_direction_above(n, random), random_direction_above(n, random)};
}

/// Around the mirror direction: the half vector lies 1e-7 to 0.1 radians from the normal, light and eye stand at least
/// 6 degrees above the horizon (cosine 0.1). An arc cosine fails here.
inline SurfacePair specular_pair(std::mt19937_64& random) {
  for (;;) {
    const Double3 n = random_direction(random);
    const Double3 h = turned(n, random_scale(random, -7, -1), random);
    const Double3 i = random_direction_above(n, random);
    const Double3 o = mirrored(i, h);
    if (dot(n, i) >= 0.1 && dot(n, o) >= 0.1) return {n, i, o};
  }
}

/// The same with light and eye 1e-6 to 0.1 radians above opposite horizons: i + o is as short.
inline SurfacePair opposite_grazing_pair(std::mt19937_64& random) {
  const Double3 n = random_direction(random);
  const Double3 aside = normalize(cross(n, random_direction(random)));
  const double height = random_scale(random, -6, -1);
  const Double3 i = normalize(aside + n * height);
  return {n, i, mirrored(i, turned(n, height * random_scale(random, -3, 0), random))};
}

/// Light from behind the eye: i lies 1e-7 to 0.1 radians from o. An arc cosine fails here too.
inline SurfacePair retro_reflective_pair(std::mt19937_64& random) {
  const Double3 n = random_direction(random);
  const Double3 i = random_direction_above(n, random);
  return {n, i, turned(i, random_scale(random, -7, -1), random)};
}

} // namespace refraster
