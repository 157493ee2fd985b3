#pragma once
// Vectors of 60 digits, and random directions.

#include "bench/precision/exact_vectors.h"
#include "tests/support/for_all.h"

namespace refraster::test {

using precision::exact, precision::inner, precision::norm, precision::outer;
using ExactVec3 = precision::Exact3;

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
