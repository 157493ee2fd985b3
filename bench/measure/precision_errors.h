#pragma once
// What each precision's image is worth.

#include "bench/measure/scene_bench.h"

namespace refraster::bench {

/// Renders the scene once in each of the task's precisions and in double, with one sample a pixel: a precision's number
/// does not depend on how many there are.
std::vector<PrecisionError> precision_errors(const SceneTask& task, int threads);

/// Images with more pixels are not compared: two of doubles would take gigabytes.
inline constexpr std::uint64_t max_compared_pixels = std::uint64_t{1} << 24;

} // namespace refraster::bench
