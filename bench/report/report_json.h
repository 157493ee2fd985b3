#pragma once
// The report of a run for programs: docs/reports.md, docs/bench.schema.json.

#include "bench/measure/results.h"

namespace refraster::bench {

std::string run_json(const Run& run);

} // namespace refraster::bench
