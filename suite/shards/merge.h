#pragma once
// Results of several folders, joined.

#include "suite/results/summary.h"

#include <string>
#include <vector>

namespace refraster::suite {

/// What was joined.
struct Merged {
  RunResults results;
  std::vector<std::string> notes; // on what of the folders cannot be read
};

/// Joins the folders' results in `folder`, with their pages and images. Of several results of one entry the last
/// counts; where two of the same files differ, or are of different files, that is a contradiction. What an entry of any
/// folder's suite has no result of is `missing`. Throws InputError for a folder without results, OutputError.
Merged merge_results(const std::vector<std::string>& folders, const std::string& folder);

} // namespace refraster::suite
