#pragma once
// Probe P10: how values are rounded to 8 bits.

#include "gl/probe/device_facts.h"
#include "gl/probe/probe_canvas.h"

namespace refraster {

OutputFacts probe_output(ProbeCanvas& canvas);

} // namespace refraster
