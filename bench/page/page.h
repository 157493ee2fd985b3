#pragma once
// The report of a run to look at.

#include "bench/measure/results.h"

namespace refraster::bench {

/// One HTML document that needs nothing else: no network, no script.
std::string run_html(const Run& run);

} // namespace refraster::bench
