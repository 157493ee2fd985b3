#pragma once
// Where the camera stands in each frame of a turntable.

#include <refraster/scene.h>

#include <vector>

namespace refraster {

/// `frames` cameras, the first of which is `start`, the others turned about start.target around start.up by equal parts
/// of a whole turn: counter-clockwise seen from the tip of `up`, so that the thing seems to turn clockwise. frames >= 1.
/// The same bits on every machine.
std::vector<Camera> orbit(const Camera& start, int frames);

} // namespace refraster
