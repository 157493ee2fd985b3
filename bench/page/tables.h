#pragma once
// The tables of the page.

#include "bench/measure/results.h"

#include <span>
#include <string>

namespace refraster::bench {

// Each is empty where there is nothing to show.
std::string frames_table(const Run& run);
/// What a user waits for; empty without it.
std::string commands_table(const Run& run);
std::string errors_table(const Run& run);
std::string costs_table(const Run& run);
std::string scaling_table(std::span<const ScalingCurve* const> curves);
std::string facts_table(const Run& run);

} // namespace refraster::bench
