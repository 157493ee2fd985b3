#pragma once
// The limits of a comparison, kept in a file.

#include <refraster/compare.h>

#include <string>

namespace refraster {

/// Reads {"max_abs": X, "max_rms": X, "max_count": N, "unit": "levels" or "values"}, each optional, the unit of the
/// first two being levels. Gives them in the unit that is asked for. Throws InputError for another key, a negative
/// number, or what is no number.
CompareLimits read_limits(const std::string& path, CompareUnit unit = CompareUnit::levels);

} // namespace refraster
