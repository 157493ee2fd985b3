#pragma once
// From a verdict to what hypotheses are asked.

#include "verify/hypotheses/rank.h"
#include "verify/verdict/verdict.h"

namespace refraster::hypotheses {

/// Pixels of the verdict, chosen at random by options.seed: of those that are unexplained, and of those that are the
/// reference, each with how far a right device may be off there. Left out are pixels that may show more than one
/// surface: what is wrong with them may be the surface. The references are those of judge(), and must outlive the
/// request.
RankRequest rank_request(const Scene& scene, const DeviceImage& image, const DeviceProfile& profile,
                         const JudgeOptions& options, const Verdict& verdict, Image<float>& actual_values);

} // namespace refraster::hypotheses
