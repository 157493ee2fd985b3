#pragma once
// Reflection by microfacets: the formula.

#include <refraster/material.h>

#include "shading/fragment.h"
#include "shading/microfacet/fresnel.h"
#include "shading/microfacet/ggx.h"

namespace refraster::inline REFRASTER_KIT {

template <Number T>
Rgb<T> ambient(const Microfacet&, const Fragment<T>&) {
  return Rgb<T>(T(0));
}

/// What a fragment of the surface is like, whatever the light: parameters times their maps.
template <class T>
struct MicrofacetSurface {
  Rgb<T> base;          // colour
  T metallic, alpha;    // alpha is the width of the density
  T ior_excess, ior_f0; // of what is not metal: ior^2 - 1, and its reflectance at normal incidence
};

template <Number T>
MicrofacetSurface<T> microfacet_surface(const Microfacet& m, const Fragment<T>& at) {
  T metallic = as<T>(m.metallic), roughness = as<T>(m.roughness);
  if (at.maps) roughness *= at.maps->specular.y, metallic *= at.maps->specular.z;
  const T ior = as<T>(m.ior), less = ior - T(1), more = ior + T(1);
  return {as<T>(m.base_color) * at.texture, metallic, square(max(roughness, as<T>(Microfacet::min_roughness))),
          less * more, square(less / more)};
}

/// F of the microfacets that mirror the light to the eye.
template <Number T>
Rgb<T> microfacet_fresnel(const Microfacet& m, const MicrofacetSurface<T>& surface, const Incidence<T>& at) {
  const auto mixed = [&](const T& dielectric, const Rgb<T>& metal) {
    return Rgb<T>((T(1) - surface.metallic) * dielectric) + metal * surface.metallic;
  };
  if (m.fresnel == MicrofacetFresnel::schlick)
    return schlick_reflectance(mixed(surface.ior_f0, surface.base), schlick_weight(at));
  const T dielectric = min(dielectric_reflectance(at.cosine, surface.ior_excess), T(1));
  if (m.fresnel == MicrofacetFresnel::dielectric)
    return mixed(dielectric, schlick_reflectance(surface.base, schlick_weight(at)));
  Rgb<T> metal;
  for (int c = 0; c < 3; ++c) metal[c] = conductor_reflectance(at, as<T>(m.eta[c]), as<T>(m.k[c]));
  return mixed(dielectric, metal);
}

/// T: what of light at cosine c, in or out, passes the boundary of what is not metal.
template <Number T>
T microfacet_transmittance(const Microfacet& m, const MicrofacetSurface<T>& surface, const T& c) {
  if (m.fresnel == MicrofacetFresnel::schlick) return (T(1) - surface.ior_f0) * schlick_transmitted_weight(c);
  return dielectric_transmittance(c, surface.ior_excess);
}

/// The pieces of the formula, for a light from l of radiance 1. 0 where it does not reach the eye.
template <class T>
struct MicrofacetTerms {
  T density;                // D(h), per steradian
  T cosine_over_divisor;    // G2 n.l / (4 n.l n.v)
  Rgb<T> fresnel;           // F(h.l)
  Rgb<T> diffuse, specular; // what the two lobes reflect: f n.l
};

/// With s = l + v and theta_d the angle from h = s / |s| to l it is
///     sin^2 theta_h = |n x s|^2 / |s|^2,   cos theta_d = |s| / 2,   sin^2 theta_d = |l - v|^2 / 4:
/// no sine comes from a cosine, nor the other way round.
template <Number T>
MicrofacetTerms<T> microfacet_terms(const Microfacet& m, const Fragment<T>& at, const Vec3<T>& l) {
  const Vec3<T>&n = at.normal, &v = at.to_eye;
  const MicrofacetSurface<T> surface = microfacet_surface(m, at);
  const GgxWidth<T> width = ggx_width(surface.alpha);
  const T n_l = max0(dot(n, l)), n_v = max0(dot(n, v));
  const MaskOf<T> lit = min(n_l, n_v) > T(0);

  const Vec3<T> s = l + v;
  const T squared_sum = squared_length(s), divisor = select(squared_sum > T(0), squared_sum, T(1));
  const T spread = ggx_spread(square(dot(n, s)) / divisor, squared_cross_with_sum(n, l, v) / divisor, width);
  MicrofacetTerms<T> terms;
  terms.density = ggx_density(select(spread > T(0), spread, T(1)), width); // 0 where |s|^2 underflows
  // Smith's divisor is at least alpha n.l: what is divided by it stays finite where both cosines are near 0, and 0 / 0
  // there is the limit as well as any number.
  const T half = as<T>(0.5);
  terms.cosine_over_divisor = max0(min(half * n_l / smith_divisor(n_l, n_v, width), half / surface.alpha));
  terms.fresnel =
      microfacet_fresnel(m, surface, {min(half * sqrt(squared_sum), T(1)), as<T>(0.25) * squared_length(l - v)});
  const T diffuse = (T(1) - surface.metallic) * constant<T>(constants::one_over_pi) *
                    microfacet_transmittance(m, surface, n_l) * microfacet_transmittance(m, surface, n_v) * n_l;
  terms.diffuse = surface.base * select(lit, diffuse, T(0));
  terms.specular = terms.fresnel * select(lit, terms.density * terms.cosine_over_divisor, T(0));
  return terms;
}

/// (diffuse + specular) C: see Microfacet in <refraster/material.h>.
template <Number T>
Rgb<T> reflected(const Microfacet& m, const Fragment<T>& at, const Incident<T>& light) {
  const MicrofacetTerms<T> terms = microfacet_terms(m, at, light.direction);
  return (terms.diffuse + terms.specular) * light.radiance;
}

} // namespace refraster::inline REFRASTER_KIT
