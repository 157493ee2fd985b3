#pragma once
// The limits of a comparison, kept in a file.

#include "verify/compare.h"

#include <string>

namespace refraster {

/// Reads {"max_abs": X, "max_rms": X, "max_count": N}, each optional. Throws InputError for another key, a negative
/// number, or what is no number.
CompareLimits read_limits(const std::string& path);

} // namespace refraster
