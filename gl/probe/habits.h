#pragma once
// Probe P7: what OpenGL leaves open of arithmetic.

#include "gl/probe/device_facts.h"
#include "gl/probe/probe_canvas.h"

namespace refraster {

HabitFacts probe_habits(ProbeCanvas& canvas);

} // namespace refraster
