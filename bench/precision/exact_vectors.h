#pragma once
// Vectors of 60 digits, and nothing of ours in them: what a formula is measured against must not share its code.

#include "math/vec.h"
#include "tests/support/ulp.h"

#include <boost/math/constants/constants.hpp>

#include <array>

namespace refraster::precision {

using Exact3 = std::array<Exact, 3>;

template <class F>
Exact3 exact(const Vec3<F>& a) {
  return {Exact(a.x), Exact(a.y), Exact(a.z)};
}

inline Exact3 operator+(const Exact3& a, const Exact3& b) {
  return {Exact(a[0] + b[0]), Exact(a[1] + b[1]), Exact(a[2] + b[2])};
}
inline Exact3 operator-(const Exact3& a, const Exact3& b) {
  return {Exact(a[0] - b[0]), Exact(a[1] - b[1]), Exact(a[2] - b[2])};
}
inline Exact3 operator*(const Exact3& a, const Exact& s) {
  return {Exact(a[0] * s), Exact(a[1] * s), Exact(a[2] * s)};
}
inline Exact inner(const Exact3& a, const Exact3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
/// The sum of the magnitudes of a dot product's terms: what its rounding errors are proportional to, however small the
/// dot product itself is.
inline Exact inner_magnitude(const Exact3& a, const Exact3& b) {
  return abs(Exact(a[0] * b[0])) + abs(Exact(a[1] * b[1])) + abs(Exact(a[2] * b[2]));
}
inline Exact3 outer(const Exact3& a, const Exact3& b) {
  return {Exact(a[1] * b[2] - a[2] * b[1]), Exact(a[2] * b[0] - a[0] * b[2]), Exact(a[0] * b[1] - a[1] * b[0])};
}
inline Exact norm(const Exact3& a) {
  return sqrt(inner(a, a));
}
inline Exact3 unit(const Exact3& a) {
  return a * Exact(1 / norm(a));
}
inline Exact positive_part(const Exact& x) {
  return x > 0 ? x : Exact(0);
}
inline const Exact& exact_pi() {
  static const Exact pi = boost::math::constants::pi<Exact>();
  return pi;
}

} // namespace refraster::precision
