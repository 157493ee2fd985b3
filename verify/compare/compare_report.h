#pragma once
// What compare() found, for people and for programs.

#include <refraster/compare.h>
#include <refraster/notes.h>

#include "verify/compare/cluster_objects.h"
#include "verify/transformations/block_compression.h"
#include "verify/transformations/transformations.h"

#include <string>
#include <vector>

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
  std::string name_b = {};                                // what a page calls file_b; its path if empty
  std::string scene = {};                                 // its file, where one says what the images show
  std::vector<ObjectCounts> objects = {};                 // with a scene: of each of found.clusters
};

/// The first line of comparison_text(): "differ by more than max-abs 2 levels".
std::string comparison_verdict(const ComparisonReport& report);

/// What kind of difference it is, where that is known, a sentence without a full stop each: "b is a turned upside down:
/// then equal within 1 level".
std::vector<std::string> comparison_causes(const ComparisonReport& report);

/// A few aligned lines; the first one is the verdict. Numbers are rounded for reading.
std::string comparison_text(const ComparisonReport& report);

/// Every number in full, members always in the same order. psnr_db is null where it is infinite; a value in `worst` is
/// null where it is NaN or infinite. docs/reports.md describes them.
std::string comparison_json(const ComparisonReport& report);

} // namespace refraster
