#pragma once
// Phong's formula.

#include <refraster/material.h>

#include "math/elementary.h"
#include "shading/fragment.h"
#include "shading/highlight_gap.h"

namespace refraster::inline REFRASTER_KIT {

/// There is no ambient light in a scene: the surface's own ka times its colour stands for it.
template <Number T>
Rgb<T> ambient(const PhongParameters& material, const Fragment<T>& at) {
  return as<T>(material.ka) * at.texture;
}

/// <a.b>^s. 0^0 is 1: an exponent of 0 makes a highlight that is everywhere. gap() is a - b, more exactly than from a
/// and b as they are rounded; asked for where that shows.
template <Number T, class Gap>
T phong_lobe(const PhongParameters& material, const Fragment<T>& at, const Vec3<T>& a, const Vec3<T>& b,
             const Gap& gap) {
  const double s = material.glossiness;
  const Double3& ks = material.ks;
  if (ks.x == 0 && ks.y == 0 && ks.z == 0) return T(0); // not used, so not paid for
  if (s == 0) at.undefined(Undefined::zero_to_the_zero, dot(a, b) <= T(0));
  if constexpr (SharpHighlights<T>) return cosine_power(a, b, highlight_gap(a, b, s, gap), s);
  else return cosine_power(a, b, s);
}

/// The colour of the highlight.
template <Number T>
Rgb<T> specular_colour(const PhongParameters& material, const Fragment<T>& at) {
  const Rgb<T> ks = as<T>(material.ks);
  return at.maps ? ks * at.maps->specular : ks;
}

/// (kd t <n.l> + ks highlight) C. 0 without a normal.
template <Number T>
Rgb<T> diffuse_and_highlight(const PhongParameters& material, const Fragment<T>& at, const Incident<T>& light,
                             const T& n_l, const T& highlight) {
  const bool open = material.specular_gate == SpecularGate::open;
  const T gated = open ? highlight : select(n_l > T(0), highlight, T(0));
  const T kept = select(squared_length(at.normal) > T(0), gated, T(0));
  return (as<T>(material.kd) * at.texture * max0(n_l) + specular_colour(material, at) * kept) * light.radiance;
}

/// r = 2 (n.l) n - l, the mirror image of l about n.
template <Number T>
Vec3<T> mirrored(const Vec3<T>& n, const Vec3<T>& l, const T& n_l) {
  return n * (T(2) * n_l) - l;
}

/// (kd t <n.l> + ks <r.v>^s) C: see Phong in <refraster/material.h>.
template <Number T>
Rgb<T> reflected(const Phong& phong, const Fragment<T>& at, const Incident<T>& light) {
  const Vec3<T> n = at.normal, l = light.direction, v = at.to_eye;
  const T n_l = dot(n, l);
  const Vec3<T> r = mirrored(n, l, n_l);
  return diffuse_and_highlight(phong, at, light, n_l, phong_lobe(phong, at, r, v, MirrorGap<T>{n, l, v}));
}

} // namespace refraster::inline REFRASTER_KIT
