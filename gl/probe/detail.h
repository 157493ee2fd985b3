#pragma once
// Probe P9: the level of detail of trilinear reads.

#include "gl/probe/device_facts.h"
#include "gl/probe/probe_canvas.h"

namespace refraster {

DetailFacts probe_detail(ProbeCanvas& canvas);

} // namespace refraster
