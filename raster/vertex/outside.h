#pragma once
// Objects that lie outside the view as a whole.

#include "raster/frame_context.h"
#include "raster/vertex/transform.h"

#include <span>
#include <vector>

namespace refraster {

/// Sets storage[i] to `outside` for objects of which it is certain that every vertex has finite clip coordinates and
/// lies outside one and the same of the six half-spaces of the clip volume, as the vertex stage computes and compares
/// them: so each of their triangles would be dropped as outside. Objects of a few vertices are not looked at, nor is the
/// only one of a scene: it would cost more than it saves.
void find_outside(const FrameInput& input, std::span<const ObjectTransform> transforms, std::vector<Storage>& storage);

} // namespace refraster
