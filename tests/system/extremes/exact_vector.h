#pragma once
// Vectors of 60 digits, and random directions.

#include "tests/support/for_all.h"
#include "tests/support/ulp.h"

#include <refraster/vector.h>

#include <array>

namespace refraster::test {

using ExactVec3 = std::array<Mpfr, 3>;

template <class T>
ExactVec3 exact_vector(const Vec3<T>& v) {
  return {Mpfr(v.x), Mpfr(v.y), Mpfr(v.z)};
}
inline Mpfr dot(const ExactVec3& a, const ExactVec3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline ExactVec3 cross(const ExactVec3& a, const ExactVec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A unit vector as T rounds it.
template <class T>
Vec3<T> random_unit(Random& random) {
  for (;;) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
    const Double3 v(x, y, z);
    if (refraster::dot(v, v) > 0.01 && refraster::dot(v, v) <= 1)
      return normalize(Vec3<T>(static_cast<T>(v.x), static_cast<T>(v.y), static_cast<T>(v.z)));
  }
}

} // namespace refraster::test
