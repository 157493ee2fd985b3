#pragma once
// Whether the way from a point of a surface to a light crosses a triangle, in integers of any length. Slow.

#include "raster/shadow/shadow_ray.h"

namespace refraster {

/// ShadowRay::crosses(), of a ray that is defined. Total: numbers of any size.
bool crosses_in_integers(const SurfacePoint& from, const LightPlace& to, const WorldTriangle& triangle);

} // namespace refraster
