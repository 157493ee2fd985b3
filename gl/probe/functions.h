#pragma once
// Probe P6: how good the functions of shaders are.

#include "gl/probe/device_facts.h"
#include "gl/probe/probe_canvas.h"

namespace refraster {

FunctionErrors probe_functions(ProbeCanvas& canvas);

} // namespace refraster
