#pragma once
// From a surface to its colour, as a hypothesis has it: the product's own formulas, with other inputs or with one piece
// of them exchanged.

#include "verify/hypotheses/prepared.h"
#include "verify/hypotheses/steps.h"
#include "verify/hypotheses/surface.h"

namespace refraster::hypotheses {

/// Linear; before what Steps::output does.
Rgb<double> colour_of(const Scene& scene, const Material& material, const Prepared& prepared, const Surface& surface,
                      const Steps& steps, const Nudge& nudge);

/// What the last step makes of it. `scale`: of Output::scaled.
Rgb<double> output_of(const Rgb<double>& linear, Output output, double scale);

} // namespace refraster::hypotheses
