#pragma once
// Probes through functions that are given: of a context that is current, or of what stands in for one.

#include "gl/probe/device_facts.h"
#include "gl/probe/probe_canvas.h"

namespace refraster {

/// As probe_device(GlRenderer), which calls it.
DeviceFacts probe_device(const GlApi& gl, const GlDriver& driver);

} // namespace refraster
