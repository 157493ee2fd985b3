#pragma once
// Which part of a suite a machine does.

#include "io/parts/shard.h"
#include "suite/references/references.h"

#include <cstddef>
#include <vector>

namespace refraster::suite {

/// What each entry may cost, in seconds where anything is known: what its reference says it took when it was stored,
/// which is the same on every machine that has the references; else by its pixels and samples, at the mean rate of
/// those that are known, or at one second a million samples. Of a size that only the scene says, 1280x720.
std::vector<double> entry_costs(const std::vector<Entry>& entries, const References& references);

/// The entries of a part, by index, in the suite's order: the longest first, each to the part that has least so far (R.
/// L. Graham, "Bounds on multiprocessing timing anomalies", 1969: the largest part is at most 4/3 of the least that is
/// possible). The same on every machine with the same suite and the same references.
std::vector<std::size_t> entries_of(const Shard& shard, const std::vector<Entry>& entries,
                                    const std::vector<double>& costs);

} // namespace refraster::suite
