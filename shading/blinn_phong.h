#pragma once
// Blinn-Phong's formula.

#include "shading/phong.h"

namespace refraster::inline REFRASTER_KIT {

/// h = (l + v) / |l + v|; 0 where l = -v.
template <Number T>
Vec3<T> half_vector(const Vec3<T>& l, const Vec3<T>& v) {
  return normalize(l + v);
}

/// Calls body(n.l, n, h, gap): the highlight is a power of n.h, and gap() is |h - n|^2, exactly.
template <Number T, class Body>
auto with_lobe(const BlinnPhong&, const Fragment<T>& at, const Vec3<T>& l, const Body& body) {
  const Vec3<T>&n = at.normal, &v = at.to_eye;
  const Vec3<T> h = half_vector(l, v);
  at.undefined(Undefined::no_half_vector, squared_length(l + v) <= T(0)); // h = 0 there
  return body(dot(n, l), n, h, [&] {
    if constexpr (SharpHighlights<T>)
      return squared_half_gap<T>(dot(l + v, h), n.x, n.y, n.z, l.x, l.y, l.z, v.x, v.y, v.z);
  });
}

/// (kd t <n.l> + ks <n.h>^s) C: see BlinnPhong in <refraster/material.h>.
template <Number T>
Rgb<T> reflected(const BlinnPhong& blinn, const Fragment<T>& at, const Incident<T>& light) {
  return with_lobe(blinn, at, light.direction, [&](const T& n_l, const Vec3<T>& n, const Vec3<T>& h, const auto& gap) {
    return diffuse_and_highlight(blinn, at, light, n_l, phong_lobe(blinn, at, n, h, gap));
  });
}

} // namespace refraster::inline REFRASTER_KIT
