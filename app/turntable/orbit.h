#pragma once
// Where the camera stands in each frame of a turntable.

#include <refraster/scene.h>

#include "io/scene/scene_source.h"

#include <vector>

namespace refraster {

/// A point turned about the line through `centre` along `axis`, of length 1, counter-clockwise seen from its tip. The
/// same bits on every machine.
Double3 rotated(const Double3& point, const Double3& centre, const Double3& axis, double degrees);

/// `frames` cameras, the first of which is `start`, the others turned about start.target around start.up by equal parts
/// of a whole turn: counter-clockwise seen from the tip of `up`, so that the thing seems to turn clockwise. frames
/// >= 1. The same bits on every machine.
std::vector<Camera> orbit(const Camera& start, int frames);

/// The same of a scene whose camera has a fit, for images of this size: every camera looks at the same point from the
/// same distance, the least one from which every frame shows all; its planes hold all that its frame shows.
std::vector<Camera> fitted_orbit(const SceneSource& source, int width, int height, int frames);

} // namespace refraster
