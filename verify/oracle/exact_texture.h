#pragma once
// The colour of a texture.

#include "verify/oracle/exact_surface.h"

namespace refraster::oracle {

/// White without one, and on triangles without texture coordinates. The levels of a mip chain are those of the texture:
/// averages in float, by rule.
Exact3 texture_colour(const Material& material, const SurfacePoint& at);

} // namespace refraster::oracle
