#pragma once
// Probe P8: places and weights of texture reads.

#include "gl/probe/device_facts.h"
#include "gl/probe/probe_canvas.h"

namespace refraster {

TextureFacts probe_texture_reads(ProbeCanvas& canvas);

} // namespace refraster
