#pragma once
// The report of a run for a terminal.

#include "app/bench/results.h"

namespace refraster::bench {

std::string run_text(const Run& run);

/// Three digits that count: "0.0123", "1.23", "123", "1.2e-16".
std::string three_digits(double x);

} // namespace refraster::bench
