#pragma once
// The folder of results: what is in it once a run has ended.

#include "suite/results/journal.h"
#include "suite/results/summary.h"

#include <string>

namespace refraster::suite {

/// Makes the folder and those below it. Throws OutputError.
void prepare_results(const std::string& folder);

/// Writes results.json, junit.xml and index.html, each whole or not at all. Throws OutputError.
void write_results(const std::string& folder, const RunResults& results);

/// The same of all that the folder's journals know, so that programs that share it, shards of one suite, end with the
/// whole: if another one's journal has grown meanwhile, the files are written once more, so that those of whoever is
/// last have everything. `own` are the results of this run; of `names`, all entries of its suite, the others are as the
/// journals have them, or `missing`. Throws OutputError.
RunResults write_joint_results(const std::string& folder, const RunResults& own, const std::vector<std::string>& names);

/// Whether the files that a result names are there.
bool files_are_there(const std::string& folder, const EntryResult& result);

} // namespace refraster::suite
