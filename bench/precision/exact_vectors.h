#pragma once
// Vectors of 60 digits, and nothing of ours in them: what a formula is measured against must not share its code.

#include "math/vec.h"
#include "tests/support/ulp.h"

#include <boost/math/constants/constants.hpp>

#include <array>

namespace refraster::precision {

using Exact3 = std::array<Mpfr, 3>;

template <class F>
Exact3 exact(const Vec3<F>& a) {
  return {Mpfr(a.x), Mpfr(a.y), Mpfr(a.z)};
}

inline Exact3 operator+(const Exact3& a, const Exact3& b) {
  return {Mpfr(a[0] + b[0]), Mpfr(a[1] + b[1]), Mpfr(a[2] + b[2])};
}
inline Exact3 operator-(const Exact3& a, const Exact3& b) {
  return {Mpfr(a[0] - b[0]), Mpfr(a[1] - b[1]), Mpfr(a[2] - b[2])};
}
inline Exact3 operator*(const Exact3& a, const Mpfr& s) {
  return {Mpfr(a[0] * s), Mpfr(a[1] * s), Mpfr(a[2] * s)};
}
inline Mpfr inner(const Exact3& a, const Exact3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
/// The sum of the magnitudes of a dot product's terms: what its rounding errors are proportional to, however small the
/// dot product itself is.
inline Mpfr inner_magnitude(const Exact3& a, const Exact3& b) {
  return abs(Mpfr(a[0] * b[0])) + abs(Mpfr(a[1] * b[1])) + abs(Mpfr(a[2] * b[2]));
}
inline Exact3 outer(const Exact3& a, const Exact3& b) {
  return {Mpfr(a[1] * b[2] - a[2] * b[1]), Mpfr(a[2] * b[0] - a[0] * b[2]), Mpfr(a[0] * b[1] - a[1] * b[0])};
}
inline Mpfr norm(const Exact3& a) {
  return sqrt(inner(a, a));
}
inline Exact3 unit(const Exact3& a) {
  return a * Mpfr(1 / norm(a));
}
inline Mpfr positive_part(const Mpfr& x) {
  return x > 0 ? x : Mpfr(0);
}
inline const Mpfr& exact_pi() {
  static const Mpfr pi = boost::math::constants::pi<Mpfr>();
  return pi;
}

} // namespace refraster::precision
