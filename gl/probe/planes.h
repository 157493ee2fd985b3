#pragma once
// Probes P4 and P5: planes of varyings and depth.

#include "gl/probe/device_facts.h"
#include "gl/probe/probe_canvas.h"

namespace refraster {

/// Random triangles of 4 to 300 pixels, in the lower left, in the middle and in the upper right of 1024 x 1024 pixels,
/// and some of 3000, which run out of the window; with corners off the lattice, which has this step.
PlaneFacts probe_planes(ProbeCanvas& canvas, double lattice);

} // namespace refraster
