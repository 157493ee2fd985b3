#pragma once
// How long frames take.

#include "gl/render_gl.h"

#include <functional>

namespace refraster {

/// Runs `frame` so many times and notes the wall time and the process's CPU time of each. `frame` must end with its
/// work done (glFinish), else the next one pays for it.
GlTimes time_frames(int count, const std::function<void()>& frame);

} // namespace refraster
