#pragma once
// Random scenes that are valid, however odd.

#include <refraster/render.h>

#include "tests/support/random.h"

namespace refraster::test {

/// A scene within what scene/scene.h allows: every shape and loose triangles, degenerate and huge ones; textures of
/// all filters; every fragment function; no light or several; numbers from the usual to the ends of their ranges. The
/// same for the same random numbers.
Scene random_scene(Random& random);

/// Up to 48 x 48 pixels, any number of samples and precision; all images are wanted.
RenderOptions random_options(Random& random);

} // namespace refraster::test
