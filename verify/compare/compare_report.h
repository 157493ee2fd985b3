#pragma once
// What compare() found, for people and for programs.

#include <refraster/compare.h>
#include <refraster/notes.h>

#include "verify/transformations/block_compression.h"
#include "verify/transformations/transformations.h"

#include <string>

namespace refraster {

/// A comparison and what it was of.
struct ComparisonReport {
  std::string file_a, file_b;
  CompareLimits limits; // in found.unit
  Comparison found;
  std::optional<double> mean_flip = {};                   // verify/compare/flip.h, where it was asked for
  std::optional<FoundTransformation> transformation = {}; // where the images differ
  Compressed compressed = Compressed::none;               // where they differ, and no transformation says why
  NoteList notes = {};                                    // of the files
};

/// A few aligned lines; the first one is the verdict. Numbers are rounded for reading.
std::string comparison_text(const ComparisonReport& report);

/// Every number in full, members always in the same order. psnr_db is null where it is infinite; a value in `worst` is
/// null where it is NaN or infinite. docs/reports.md describes them.
std::string comparison_json(const ComparisonReport& report);

} // namespace refraster
