#pragma once
// The fragment functions from their textbook formulas, in 60 digits.

#include "bench/precision/exact_vectors.h"
#include "bench/precision/inputs.h"
#include "shading/merl_lookup.h"

namespace refraster::precision {

/// A radiance, and the sum of the magnitudes of the terms it is made from.
struct Exactly {
  Exact value, terms;
};

/// n, l, v as they were given, or exactly unit where the path computes them; C with its attenuation.
struct ExactLit {
  Exact3 n, l, v;
  Exact radiance;
};
ExactLit exactly_lit(const Inputs& in);

/// (kd t <n.l> + ks cos^s) C, with cos the cosine of the angle between r = 2 (n.l) n - l and v.
/// Its terms: (kd t sum |n_i l_i| + ks) C. A highlight counts with its peak.
Exactly exact_phong(const Inputs& in);
/// The same with the angle between n and h = (l + v) / |l + v|.
Exactly exact_blinn_phong(const Inputs& in);

/// Rusinkiewicz's coordinates in bins by their definition: half vector, arc cosines, and the azimuth of i in a frame
/// whose pole is h. w in [0, 180). i and o are divided by their lengths first.
using ExactPoint = MerlPoint<Exact>;
ExactPoint exact_merl_point(const Exact3& n, const Exact3& i, const Exact3& o);

/// How far two values of w are apart on their circle of 180.
Exact distance_around(const Exact& w, const Exact& other);

/// What a point of a MERL table is made from, for all lookups: the coordinates and how much a relative change of the
/// inputs moves each, that is the sum of |x du/dx| over the nine components x of n, l, v.
struct MerlPlace {
  ExactLit lit;
  ExactPoint at, moved;
};
MerlPlace exact_merl_place(const Inputs& in);

/// f <n.l> C in one channel. Its terms: (f + |df/du| (u + du) + |df/dv| (v + dv) + |df/dw| (w + dw)) sum |n_i l_i| C
/// with du, dv, dw from `moved`: what becomes of rounding the directions and the coordinates. Where logarithms g are
/// interpolated, f + |df/dg| (g + |dg/du| (u + du) + ...) stands in the brackets.
Exactly exact_merl(const MerlPlace& place, const MerlTable& table, MerlLookup lookup, int channel);

} // namespace refraster::precision
