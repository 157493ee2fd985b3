#pragma once
// From a triangle and a place in it to what shading starts from, as a hypothesis has it.

#include "math/vec.h"
#include "raster/shade/sample_data.h"
#include "shading/fragment.h"
#include "verify/hypotheses/prepared.h"
#include "verify/hypotheses/steps.h"

#include <optional>

namespace refraster::hypotheses {

/// How far inputs are moved that a right device rounds: to see how much the colour moves.
struct Nudge {
  double detail = 0;  // of the level of detail
  double texel = 0;   // of a texel, in units of the texture's full scale
  double lobe = 0;    // of the cosine that a highlight is a power of, relative to the lengths that it is computed from
  int angle_ulps = 0; // of the cosine of an arc cosine, 2^-24 each
};

struct Surface {
  Double3 position{0}, normal{0}, to_eye{0};
  Double3 mesh_normal{0}; // as it is interpolated, of any length: what the slope in a shadow map follows from
  Rgb<double> texture{1};
  bool unit = true;                         // normal and direction to the eye are unit, or 0
  std::optional<FragmentMaps<double>> maps; // of a material that has any: as they are right
};

/// At the sample that `data` was moved to.
Surface surface_at(const FrameContext& context, const SampleData<double>& data, const Prepared& prepared,
                   const Steps& steps, const Nudge& nudge);

} // namespace refraster::hypotheses
