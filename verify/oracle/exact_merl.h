#pragma once
// A measured BRDF between its samples.

#include "shading/merl_lookup.h"
#include "verify/oracle/exact.h"

namespace refraster::oracle {

/// f in 1/sr for unit vectors n, i, o. Rusinkiewicz's angles by their definition: half vector, arc cosines, and the
/// azimuth of i in a frame whose pole is the half vector; where that is undefined, pi / 2 as the renderer has it.
Exact3 merl_brdf(const MerlTable& table, MerlLookup lookup, const Exact3& n, const Exact3& i, const Exact3& o);

} // namespace refraster::oracle
