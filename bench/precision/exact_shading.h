#pragma once
// The fragment functions in 60 digits: the formulas of shading/ themselves, over Exact.

#include "bench/precision/inputs.h"
#include "math/exact.h"
#include "shading/merl_lookup.h"
#include "shading/microfacet/microfacet.h"

namespace refraster::precision {

/// A radiance, and the sum of the magnitudes of the terms it is made from.
struct Exactly {
  Exact value, terms;
};

/// |x|.|y|: the sum of the magnitudes of a dot product's terms, which its rounding errors are proportional to, however
/// small the dot product itself is.
inline Exact magnitude_of_dot(const Vec3<Exact>& a, const Vec3<Exact>& b) {
  return abs(a.x * b.x) + abs(a.y * b.y) + abs(a.z * b.z);
}

/// What Phong or Blinn-Phong gives. Its terms: (kd t sum |n_i l_i| + ks) C. A highlight counts with its peak.
template <class SomeFunction>
Exactly exactly(const SomeFunction& function, const Inputs& in) {
  const Lit<Exact> there = lit<Exact>(in);
  const Exact diffuse = as<Exact>(in.kd) * as<Exact>(in.texture);
  return {reflected(function, there.at, there.light).x,
          (diffuse * magnitude_of_dot(there.at.normal, there.light.direction) + as<Exact>(in.ks)) *
              there.light.radiance.x};
}

/// What microfacets give. Its terms: those of its two lobes with sum |n_i l_i| for n.l, and the density at its peak.
inline Exactly exactly(const Microfacet& function, const Inputs& in) {
  const Lit<Exact> there = lit<Exact>(in);
  const Vec3<Exact>&n = there.at.normal, &l = there.light.direction;
  const MicrofacetTerms<Exact> terms = microfacet_terms(function, there.at, l);
  const Exact value = (terms.diffuse.x + terms.specular.x) * there.light.radiance.x, n_l = dot(n, l);
  if (!(n_l > Exact(0)) || !(terms.diffuse.x > Exact(0))) return {value, value};
  const GgxWidth<Exact> width = ggx_width(microfacet_surface(function, there.at).alpha);
  const Exact specular = terms.fresnel.x * terms.cosine_over_divisor * width.squared_over_pi / square(width.squared);
  return {value, (terms.diffuse.x + specular) * (magnitude_of_dot(n, l) / n_l) * there.light.radiance.x};
}

/// Rusinkiewicz's coordinates in bins, of the directions brought to unit length first. w in [0, 180).
using ExactPoint = MerlPoint<Exact>;
template <class F>
ExactPoint exact_merl_point(const Vec3<F>& n, const Vec3<F>& i, const Vec3<F>& o) {
  const auto unit = [](const Vec3<F>& a) { return normalize(Vec3<Exact>(Exact(a.x), Exact(a.y), Exact(a.z))); };
  return merl_point(half_difference(MerlAngles::closed, unit(n), unit(i), unit(o)));
}

/// How far two values of w are apart on their circle of 180.
Exact distance_around(const Exact& w, const Exact& other);

/// What a point of a MERL table is made from, for all lookups: the coordinates and how much a relative change of the
/// inputs moves each, that is the sum of |x du/dx| over the nine components x of n, l, v.
struct MerlPlace {
  Lit<Exact> lit;
  ExactPoint at, moved;
};
MerlPlace exact_merl_place(const Inputs& in);

/// f <n.l> C in one channel. Its terms: (f + |df/du| (u + du) + |df/dv| (v + dv) + |df/dw| (w + dw)) sum |n_i l_i| C
/// with du, dv, dw from `moved`: what becomes of rounding the directions and the coordinates. Where logarithms g are
/// interpolated, |df/dg| g is added in the brackets.
Exactly exact_merl(const MerlPlace& place, const MerlTable& table, MerlLookup lookup, int channel);

} // namespace refraster::precision
