#pragma once
// Measured reflection as a hypothesis has it.

#include "shading/fragment.h"
#include "verify/hypotheses/prepared.h"
#include "verify/hypotheses/steps.h"
#include "verify/hypotheses/surface.h"

namespace refraster::hypotheses {

Rgb<double> reflected_with(const Merl& merl, const Fragment<double>& at, const Incident<double>& light,
                           const Prepared& prepared, const Steps& steps, const Nudge& nudge);

} // namespace refraster::hypotheses
