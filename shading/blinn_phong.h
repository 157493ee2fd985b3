#pragma once
// Blinn-Phong's formula.

#include "shading/phong.h"

namespace refraster::inline REFRASTER_KIT {

/// h = (l + v) / |l + v|; 0 where l = -v.
template <Number T>
Vec3<T> half_vector(const Vec3<T>& l, const Vec3<T>& v) {
  return normalize(l + v);
}

/// (kd t <n.l> + ks <n.h>^s) C: see BlinnPhong in <refraster/material.h>.
template <Number T>
Rgb<T> reflected(const BlinnPhong& blinn, const Fragment<T>& at, const Incident<T>& light) {
  const Vec3<T> n = at.normal, l = light.direction, v = at.to_eye;
  const Vec3<T> h = half_vector(l, v);
  at.undefined(Undefined::no_half_vector, squared_length(l + v) <= T(0)); // h = 0 there
  return diffuse_and_highlight(blinn, at, light, dot(n, l), phong_lobe(blinn, at, n, h, HalfGap<T>{n, l, v, h}));
}

} // namespace refraster::inline REFRASTER_KIT
