#pragma once
// What makes the figures of a run worth little.

#include "bench/measure/results.h"

#include <string>
#include <vector>

namespace refraster::bench {

/// Sentences for the notes of a run, none if there is nothing to say:
/// - other programs wanted the CPUs that the threads ran on, by the load average at the start or the end;
/// - times scatter so much from repetition to repetition that the second digit of their median means nothing: its
///   standard error is above 5 %, the most that rounding to two digits changes a number by;
/// - there are fewer than three repetitions, of which no spread is known.
std::vector<std::string> doubts(const Run& run);

} // namespace refraster::bench
