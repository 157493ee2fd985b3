#pragma once
// Measures what an OpenGL device does, with small draws off screen.

#include "gl/gl_names.h"
#include "gl/probe/device_facts.h"

namespace refraster {

/// Changes when a probe measures something else, or in another way.
inline constexpr int probe_version = 1;

/// Draws the probes with this renderer, in a context of its own; seconds, and a few with a software driver. Throws
/// NoOpenGl; InputError for a driver that refuses a probe's shader. As render_gl, not from two threads at once.
DeviceFacts probe_device(GlRenderer renderer);

} // namespace refraster
