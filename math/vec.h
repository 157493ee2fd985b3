#pragma once
// Vectors and colours of any Number: our own geometric functions for GLM's types. GLM 0.9.9 refuses its own `dot`,
// `length` and `normalize` on numbers it does not know; these are more specialised, so they are chosen for every T.

#include <refraster/vector.h>

#include "math/number.h"

#include <type_traits>

namespace refraster::inline REFRASTER_KIT {

/// Parameters enter a formula channel by channel, each rounded once.
template <class T>
Vec3<T> as(const Double3& parameter) {
  return {as<T>(parameter.x), as<T>(parameter.y), as<T>(parameter.z)};
}

/// a, component by component: GCC 12 copies a whole vector of lanes through memory.
template <class T>
Vec3<T> copied(const Vec3<T>& a) {
  return {a.x, a.y, a.z};
}

template <class T>
T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return multiply_add(a.z, b.z, multiply_add(a.y, b.y, a.x * b.x));
}

template <class T>
Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// |a|^2. Overflows and underflows where the square does: for unit-sized vectors.
template <class T>
T squared_length(const Vec3<T>& a) {
  if constexpr (is_fast<T>) return dot(a, a);
  else return square(a.x) + square(a.y) + square(a.z); // a bounds type knows that these are not negative
}

/// A power of two that brings the largest component of a into [1, 2); see reciprocal_binade.
template <class T>
T reciprocal_binade(const Vec3<T>& a) {
  return reciprocal_binade(max(abs(a.x), max(abs(a.y), abs(a.z))));
}

/// |a|, without overflow or underflow on the way. A bounds number brings its own, which knows that |a| grows with each
/// component.
template <class T>
T length(const Vec3<T>& a) {
  if constexpr (!NumberTraits<T>::is_ieee) { // neither overflows nor underflows
    return sqrt(squared_length(a));
  } else {
    const auto scaled = [&] {
      const T scale = reciprocal_binade(a);
      return sqrt(squared_length(a * scale)) * exact_reciprocal(scale);
    };
    if constexpr (NumberTraits<T>::has_lanes) {
      const T squared = squared_length(a);
      const MaskOf<T> ordinary = square_in_range(squared);
      if constexpr (is_fast<T>) {
        const T estimated = squared * reciprocal_root(squared);
        return any(!ordinary) ? select(ordinary, estimated, scaled()) : estimated;
      }
      if (!any(!ordinary)) [[likely]]
        return sqrt(squared);
    }
    return scaled();
  }
}

/// Whether squares can be added up as they are. Where they can, scaling by a power of two first would change no bit of
/// the sum's root.
template <class T>
MaskOf<T> square_in_range(const T& squared_length) {
  constexpr auto far = static_cast<RealOf<T>>(sizeof(RealOf<T>) == 4 ? 0x1p40 : 0x1p400);
  return (squared_length >= T(1 / far)) & (squared_length <= T(far));
}

/// length(a) and normalize(a).
template <class T>
struct LengthAndDirection {
  T length;
  Vec3<T> direction;
};

/// Of lanes: the two share a square root. Branches join in numbers, never in vectors: GCC 12 sends those through
/// memory.
template <class T>
  requires(NumberTraits<T>::has_lanes&& NumberTraits<T>::is_ieee)
LengthAndDirection<T> length_and_direction(const Vec3<T>& a) {
  T x = a.x, y = a.y, z = a.z, squared = squared_length(a), back(1);
  const MaskOf<T> ordinary = square_in_range(squared);
  const bool is_rare = any(!ordinary);
  if (is_rare) [[unlikely]] {
    // What lies beside it in a register must not matter: an estimate has other bits, and a component that is subnormal
    // would lose its last ones twice where it is scaled first.
    const T scale = select(ordinary, T(1), reciprocal_binade(a));
    x *= scale, y *= scale, z *= scale;
    squared = squared_length(Vec3<T>(x, y, z)); // in [1, 12), or 0, where it was not ordinary
    back = exact_reciprocal(scale);
  }
  T length, inverse;
  if constexpr (is_fast<T>) inverse = reciprocal_root(squared), length = squared * inverse;
  else length = sqrt(squared), inverse = T(1) / length;
  if (is_rare) [[unlikely]] {
    if constexpr (is_fast<T>) {
      const T root = sqrt(squared);
      length = select(ordinary, length, root), inverse = select(ordinary, inverse, T(1) / root);
    }
    length *= back;
    inverse = select(squared > T(0), inverse, T(0));
  }
  return {length, {x * inverse, y * inverse, z * inverse}};
}

/// a / |a|, likewise, for every finite a but 0, which gives 0: also for components of 1e30 or 1e-30 in float.
template <class T>
Vec3<T> normalize(const Vec3<T>& a) {
  if constexpr (!NumberTraits<T>::is_ieee) {
    const T squared = squared_length(a);
    const MaskOf<T> defined = squared > T(0);
    return a * select(defined, T(1) / sqrt(select(defined, squared, T(1))), T(0));
  } else if constexpr (NumberTraits<T>::has_lanes) {
    return copied(length_and_direction(a).direction);
  } else {
    const T squared = squared_length(a);
    if (square_in_range(squared)) return a * (T(1) / sqrt(squared));
    const Vec3<T> scaled = a * reciprocal_binade(a);
    const T scaled_squared = squared_length(scaled); // in [1, 12), or 0
    return scaled * select(scaled_squared > T(0), T(1) / sqrt(scaled_squared), T(0));
  }
}

template <class T>
LengthAndDirection<T> length_and_direction(const Vec3<T>& a) {
  return {length(a), normalize(a)};
}

template <class T>
Double3 within_range(const Double3& a) {
  return {within_range<T>(a.x), within_range<T>(a.y), within_range<T>(a.z)};
}

/// From a to b, and exactly a for a = b.
template <class T>
Vec3<T> mix(const Vec3<T>& a, const Vec3<T>& b, const T& fraction) {
  const auto component = [&](const T& x, const T& y) { return multiply_add(y - x, fraction, x); };
  return {component(a.x, b.x), component(a.y, b.y), component(a.z, b.z)};
}
template <class T>
Vec4<T> mix(const Vec4<T>& a, const Vec4<T>& b, const T& fraction) {
  const auto component = [&](const T& x, const T& y) { return multiply_add(y - x, fraction, x); };
  return {component(a.x, b.x), component(a.y, b.y), component(a.z, b.z), component(a.w, b.w)};
}

/// The Catmull-Rom spline through four values, between b and c.
template <class T>
Vec4<T> mix_cubic(const Vec4<T>& a, const Vec4<T>& b, const Vec4<T>& c, const Vec4<T>& d, const T& fraction) {
  const Vec4<T> slope_b = (c - a) * as<T>(0.5), slope_c = (d - b) * as<T>(0.5), rise = c - b;
  return b + (slope_b +
              (rise * T(3) - slope_b * T(2) - slope_c + (slope_b + slope_c - rise * T(2)) * fraction) * fraction) *
                 fraction;
}

template <class T>
Vec3<T> select(const MaskOf<T>& m, const Vec3<T>& a, const Vec3<T>& b) {
  return {select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z)};
}

} // namespace refraster::inline REFRASTER_KIT
