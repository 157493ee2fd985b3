#pragma once
// Light that arrives at a point and leaves toward the eye.

#include "verify/oracle/exact_surface.h"

#include <optional>

namespace refraster::oracle {

/// Nothing where the formulas leave a direction undefined, and for a fragment function that has no formula here.
std::optional<Exact3> radiance(const Scene& scene, const Object& object, const SurfacePoint& at);

} // namespace refraster::oracle
