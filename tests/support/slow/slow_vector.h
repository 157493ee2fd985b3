#pragma once
// Three long doubles. The slow path shares no arithmetic with what it judges.

#include <cmath>

namespace refraster::slow {

using Real = long double;
constexpr Real real(auto x) {
  return static_cast<Real>(x);
}

struct Vec {
  Real x = 0, y = 0, z = 0;
};
inline Vec operator+(Vec a, Vec b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec operator-(Vec a, Vec b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec operator*(Vec a, Real s) {
  return {a.x * s, a.y * s, a.z * s};
}
inline Vec operator*(Vec a, Vec b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
inline Real dot(Vec a, Vec b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec cross(Vec a, Vec b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Real length(Vec a) {
  return std::sqrt(dot(a, a));
}
inline Vec unit(Vec a) {
  return a * (1 / length(a));
}

template <class GlmVector>
Vec vec(const GlmVector& v) {
  return {real(v.x), real(v.y), real(v.z)};
}

} // namespace refraster::slow
