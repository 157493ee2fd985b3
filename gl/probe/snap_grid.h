#pragma once
// Probe P1: to which lattice corners are rounded.

#include "gl/probe/device_facts.h"
#include "gl/probe/probe_canvas.h"

namespace refraster {

/// A nearly upright edge is moved by multiples of the resolution, and the row where it crosses a column of pixel
/// centres shows where it is drawn: a staircase whose step is the lattice.
std::vector<SnapGrid> probe_snap_grid(ProbeCanvas& canvas);

} // namespace refraster
