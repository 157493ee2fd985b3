#pragma once
// Values at pairs of directions, as text.

#include "brdf/brdf.h"

#include <span>
#include <string>

namespace refraster {

/// CSV: theta_in,theta_out,dphi,theta_h,theta_d,phi_d,r,g,b, angles in degrees, f in 1/sr; numbers read back as the
/// same double. r, g and b are nan where a table has no sample around.
std::string evaluation_csv(const Brdf& brdf, std::span<const DirectionPair> pairs);

/// The same as JSON: docs/reports.md.
std::string evaluation_json(const Brdf& brdf, std::span<const DirectionPair> pairs);

} // namespace refraster
