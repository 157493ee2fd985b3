#pragma once
// Numbers and vectors of 60 digits.

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cstddef>

namespace refraster::oracle {

/// 60 digits: four times those of double, so that what cancels, or is lost in an arc cosine near 1, leaves enough.
using Exact = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<60>, boost::multiprecision::et_off>;

struct Exact3 {
  Exact x = 0, y = 0, z = 0;
  Exact& operator[](std::size_t i) { return i == 0 ? x : i == 1 ? y : z; }
  const Exact& operator[](std::size_t i) const { return i == 0 ? x : i == 1 ? y : z; }
};

/// From float or double, unchanged.
template <class GlmVector>
Exact3 exact(const GlmVector& v) {
  return {Exact(v.x), Exact(v.y), Exact(v.z)};
}

inline Exact3 operator+(const Exact3& a, const Exact3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Exact3 operator-(const Exact3& a, const Exact3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Exact3 operator*(const Exact3& a, const Exact& s) {
  return {a.x * s, a.y * s, a.z * s};
}
/// Channel by channel.
inline Exact3 operator*(const Exact3& a, const Exact3& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
inline Exact dot(const Exact3& a, const Exact3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Exact3 cross(const Exact3& a, const Exact3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Exact length(const Exact3& a) {
  return sqrt(dot(a, a));
}
/// Of a vector that is not 0.
inline Exact3 unit(const Exact3& a) {
  return a * (1 / length(a));
}
inline Exact positive(const Exact& x) {
  return x > 0 ? x : Exact(0);
}
inline const Exact& pi() {
  static const Exact value = boost::math::constants::pi<Exact>();
  return value;
}
/// The greatest integer not above x, which must fit.
inline long whole(const Exact& x) {
  return static_cast<long>(floor(x));
}

} // namespace refraster::oracle
