#pragma once
// Probe P2: which triangle shows a sample that lies exactly on an edge.

#include "gl/probe/device_facts.h"
#include "gl/probe/probe_canvas.h"

namespace refraster {

/// Eight triangles around the centre of a pixel, whose edges run through centres in eight directions, in both windings.
TieFacts probe_tie_rule(ProbeCanvas& canvas);

} // namespace refraster
