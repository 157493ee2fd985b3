#pragma once
// Reflection measured: the formula.

#include "shading/fragment.h"
#include "shading/merl_lookup.h"

namespace refraster::inline REFRASTER_KIT {

template <Number T>
Rgb<T> ambient(const Merl&, const Fragment<T>&) {
  return Rgb<T>(T(0));
}

/// f(l, v) <n.l> C, 0 unless n.l > 0 and n.v > 0: see Merl in <refraster/material.h>.
template <Number T>
Rgb<T> reflected(const Merl& merl, const Fragment<T>& at, const Incident<T>& light) {
  const Vec3<T> n = at.normal, l = light.direction, v = at.to_eye;
  const T n_l = dot(n, l);
  const MerlValue<T> brdf = merl_value(*merl.table, merl.lookup, merl_point(half_difference(merl.angles, n, l, v)));
  const MaskOf<T> lit = min(n_l, dot(n, v)) > T(0);
  at.undefined(Undefined::unmeasured_brdf, lit & brdf.unmeasured);
  return select<T>(lit, brdf.f * n_l * light.radiance, Rgb<T>(T(0)));
}

} // namespace refraster::inline REFRASTER_KIT
