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

/// |a - b|^2 / 2, as lanes take it for the power of a cosine. gap() knows |a - b|^2 more exactly than a and b do, as
/// they are rounded; `sharp` is sharp_gap() of the glossiness.
template <Lanes T, class Gap>
T half_squared_gap(const Vec3<T>& a, const Vec3<T>& b, double sharp, const Gap& gap) {
  if constexpr (SharpHighlights<T>) return T(0.5) * squared_gap(a, b, sharp, gap);
  else return T(0.5f) * squared_length(a - b);
}

/// 0^0 is 1: an exponent of 0 makes a highlight that is everywhere.
template <Number T>
void note_zero_to_the_zero(const Fragment<T>& at, const Vec3<T>& a, const Vec3<T>& b) {
  at.undefined(Undefined::zero_to_the_zero, dot(a, b) <= T(0));
}

/// <a.b>^s.
template <class Function, Number T, class Gap>
T phong_lobe(const Function& material, const Fragment<T>& at, const Vec3<T>& a, const Vec3<T>& b, const Gap& gap) {
  const double s = material.glossiness;
  if (material.ks == Double3(0)) return T(0); // not used, so not paid for
  if (s == 0) note_zero_to_the_zero(at, a, b);
  if constexpr (Lanes<T>) {
    const T q = half_squared_gap(a, b, sharp_gap(s, plain_glossiness<Function>), gap);
    return cosine_power(cosine_of(a, b, q), q, cosine_exponent<RealOf<T>>(s));
  } else {
    return cosine_power(a, b, s);
  }
}

/// The colour of the diffuse part.
template <Number T>
Rgb<T> diffuse_colour(const PhongParameters& material, const Fragment<T>& at) {
  return as<T>(material.kd) * at.texture;
}

/// The colour of the highlight.
template <Number T>
Rgb<T> specular_colour(const PhongParameters& material, const Fragment<T>& at) {
  const Rgb<T> ks = as<T>(material.ks);
  return at.maps ? ks * at.maps->specular : ks;
}

/// x, or 0 without a normal: the highlight, or its colour.
template <Number T>
T where_normal(const Fragment<T>& at, const T& x) {
  return select(squared_length(at.normal) > T(0), x, T(0));
}

/// A highlight, or 0 where the gate cuts it.
template <Number T>
T gated(SpecularGate gate, const T& n_l, const T& highlight) {
  return gate == SpecularGate::open ? highlight : select(n_l > T(0), highlight, T(0));
}

/// (diffuse <n.l> + specular highlight) C.
template <Number T>
Rgb<T> diffuse_and_highlight(const Rgb<T>& diffuse, const Rgb<T>& specular, const T& n_l, const T& highlight,
                             const Rgb<T>& radiance) {
  return (diffuse * max0(n_l) + specular * highlight) * radiance;
}

/// (kd t <n.l> + ks highlight) C. 0 without a normal.
template <Number T>
Rgb<T> diffuse_and_highlight(const PhongParameters& material, const Fragment<T>& at, const Incident<T>& light,
                             const T& n_l, const T& highlight) {
  const T kept = where_normal(at, gated(material.specular_gate, n_l, highlight));
  return diffuse_and_highlight(diffuse_colour(material, at), specular_colour(material, at), n_l, kept, light.radiance);
}

/// r = 2 (n.l) n - l, the mirror image of l about n.
template <Number T>
Vec3<T> mirrored(const Vec3<T>& n, const Vec3<T>& l, const T& n_l) {
  return n * (T(2) * n_l) - l;
}

/// Calls body(n.l, r, v, gap): the highlight is a power of r.v, and gap() is |r - v|^2, exactly.
template <Number T, class Body>
auto with_lobe(const Phong&, const Fragment<T>& at, const Vec3<T>& l, const Body& body) {
  const Vec3<T>&n = at.normal, &v = at.to_eye;
  const T n_l = dot(n, l);
  return body(n_l, mirrored(n, l, n_l), v, [&] {
    if constexpr (SharpHighlights<T>) return squared_mirror_gap<T>(n.x, n.y, n.z, l.x, l.y, l.z, v.x, v.y, v.z);
  });
}

/// (kd t <n.l> + ks <r.v>^s) C: see Phong in <refraster/material.h>.
template <Number T>
Rgb<T> reflected(const Phong& phong, const Fragment<T>& at, const Incident<T>& light) {
  return with_lobe(phong, at, light.direction, [&](const T& n_l, const Vec3<T>& r, const Vec3<T>& v, const auto& gap) {
    return diffuse_and_highlight(phong, at, light, n_l, phong_lobe(phong, at, r, v, gap));
  });
}

} // namespace refraster::inline REFRASTER_KIT
