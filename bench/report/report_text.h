#pragma once
// The report of a run for a terminal.

#include "bench/measure/results.h"

namespace refraster::bench {

std::string run_text(const Run& run);

/// A difference of two measurements as a cost: "3.21"; "< 0.3" where it is smaller than its spread; "saves 3.21" where
/// it is below 0 by more than that. The quartiles beside it: of what is saved, where it is; nothing where it is below
/// its spread.
struct CostText {
  std::string median, lower, upper;
};
CostText cost_text(const Spread& difference);

/// A part of a frame's time, "1.23": of the fragment functions, which are a difference, as cost_text has it.
std::string part_text(const PrecisionResult& precision, double Split::*part);

/// Three digits that count: "0.0123", "1.23", "123", "1.2e-16".
std::string three_digits(double x);

} // namespace refraster::bench
