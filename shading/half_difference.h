#pragma once
// From two directions to the half and difference angles of a measured BRDF.

#include <refraster/material.h>

#include "math/constants.h"
#include "math/elementary.h"

#include <string_view>
#include <utility>

namespace refraster::inline REFRASTER_KIT {

/// Rusinkiewicz's coordinates of an isotropic BRDF, in radians. With h = (i + o) / |i + o|:
///   theta_h in [0, pi/2]  from the normal n to h
///   theta_d in [0, pi/2]  from h to the light direction i, or the view direction o
///   phi_d   in [0, pi)    azimuth of i about h, counted from the plane of n and h; i and o may be swapped, so it is
///                         known modulo pi only
/// Rusinkiewicz, "A new change of variables for efficient BRDF representation", 1998.
template <class T>
struct HalfDifference {
  T theta_h, theta_d, phi_d;
};

/// (cos phi_d, sin phi_d) times any factor: a vector along the azimuth, or against it. The closed form
///
///     (|s| n.d,  2 n.(i x o)),     s = i + o,  d = i - o.
///
/// d is perpendicular to s, so with x' = (n.h) h - n pointing along phi_d = 0 and y' = h x x', its components are
/// d.x' = -n.d and d.y' = -n.(h x d) = -2 n.(i x o) / |s|. No half vector, no frame, no special direction.
/// Swapping i and o changes the sign of both components and no bit beside.
template <Number T>
Vec2<T> difference_azimuth_closed(const Vec3<T>& n, const Vec3<T>& i, const Vec3<T>& o) {
  return {sqrt(squared_length(i + o)) * dot(n, i - o), T(2) * dot(n, cross(i, o))};
}

/// Two unit vectors that form a right-handed basis with n. Duff et al., "Building an orthonormal basis, revisited",
/// 2017.
template <class T>
struct Tangents {
  Vec3<T> tangent, bitangent;
};

template <Number T>
Tangents<T> tangents(const Vec3<T>& n) {
  const T side = select(n.z >= T(0), T(1), T(-1));
  const T a = T(-1) / (side + n.z);
  const T b = n.x * n.y * a;
  return {{T(1) + side * square(n.x) * a, side * b, -side * n.x}, {b, side + square(n.y) * a, -n.y}};
}

/// The same by rotation: turn h and i by -phi_h about the normal, then by -theta_h about the bitangent; h now lies on
/// the pole, and i at (theta_d, phi_d). Sines and cosines come from the components of h, not from angles.
template <Number T>
Vec2<T> difference_azimuth_rotation(const Vec3<T>& n, const Vec3<T>& i, const Vec3<T>& o) {
  const auto [tangent, bitangent] = tangents(n);
  const Vec3<T> h = normalize(i + o);
  const T h_x = dot(h, tangent), h_y = dot(h, bitangent);
  const T cos_theta_h = dot(h, n);
  const T sin_theta_h = sqrt(square(h_x) + square(h_y));
  const T cos_phi_h = select(sin_theta_h > T(0), h_x / sin_theta_h, T(1));
  const T sin_phi_h = select(sin_theta_h > T(0), h_y / sin_theta_h, T(0));

  const T i_x = dot(i, tangent), i_y = dot(i, bitangent), i_z = dot(i, n);
  const T upright_x = cos_phi_h * i_x + sin_phi_h * i_y;
  const T upright_y = cos_phi_h * i_y - sin_phi_h * i_x;
  return {cos_theta_h * upright_x - sin_theta_h * i_z, upright_y};
}

/// The same by a change of frame: h is the new z axis, x' lies in the plane of n and h, y' = h x x'; the azimuth is
/// that of p, the part of i perpendicular to h.
template <Number T>
Vec2<T> difference_azimuth_frame(const Vec3<T>& n, const Vec3<T>& i, const Vec3<T>& o) {
  const Vec3<T> h = normalize(i + o);
  const Vec3<T> h_x = h * dot(n, h) - n; // any positive factor: the azimuth of p does not depend on it
  const Vec3<T> h_y = cross(h, h_x);
  const Vec3<T> p = i - h * dot(i, h);
  return {dot(p, h_x), dot(p, h_y)};
}

template <Number T>
Vec2<T> difference_azimuth(MerlAngles method, const Vec3<T>& n, const Vec3<T>& i, const Vec3<T>& o) {
  switch (method) {
  case MerlAngles::closed:
    return difference_azimuth_closed(n, i, o);
  case MerlAngles::rotation:
    return difference_azimuth_rotation(n, i, o);
  case MerlAngles::frame:
    return difference_azimuth_frame(n, i, o);
  }
  return {T(0), T(0)};
}

/// The direction of the line through 0 and (x, y), in [0, pi). The point is first turned into the upper half plane, so
/// that (x, y) and (-x, -y) give the same bits; an angle that rounds to pi is 0. A bounds number has its own.
template <Number T>
T line_angle(const Vec2<T>& point) {
  const T upper_x = select(point.y < T(0), -point.x, select(point.y > T(0), point.x, abs(point.x)));
  const T angle = atan2(abs(point.y), upper_x);
  return select(angle < constant<T>(constants::pi), angle, T(0));
}

/// The coordinates of light direction i and view direction o at a surface with normal n: unit vectors, in any order of
/// i and o; with MerlAngles::closed that order changes no bit.
///     theta_h = atan2(|n x s|, n.s),  theta_d = atan2(|d|, |s|),     s = i + o,  d = i - o
/// Neither is an arc cosine, which loses half of all digits at a highlight (docs/merl.md).
/// Where phi_d is undefined it is pi/2: for h = n, i = o and i = -o. For i = -o, theta_h is 0 and theta_d is pi/2.
template <Number T>
HalfDifference<T> half_difference(MerlAngles method, const Vec3<T>& n, const Vec3<T>& i, const Vec3<T>& o) {
  const Vec3<T> s = i + o, d = i - o;
  const T sin_h = sqrt(squared_length(cross(n, s))); // |s| sin theta_h
  const T sin_d = sqrt(squared_length(d));           // 2 sin theta_d
  const T cos_d = sqrt(squared_length(s));           // 2 cos theta_d
  const Vec2<T> azimuth = difference_azimuth(method, n, i, o);
  const T defined = min(min(sin_h, sin_d), max(abs(azimuth.x), abs(azimuth.y)));
  return {atan2(sin_h, dot(n, s)), atan2(sin_d, cos_d),
          select(defined > T(0), line_angle(azimuth), constant<T>(constants::half_pi))};
}

} // namespace refraster::inline REFRASTER_KIT
