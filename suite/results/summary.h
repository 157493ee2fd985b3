#pragma once
// What came of a run, in words and in the formats of build servers.

#include "suite/entry/result.h"

#include <string>
#include <vector>

namespace refraster::suite {

/// The results of a run, the worst first.
struct RunResults {
  std::string suite; // its file; empty: of the command line
  std::vector<EntryResult> entries;
  std::vector<std::string> contradictions; // of results that were joined
  double seconds = 0;                      // of this run

  void sort();
  /// Contradictions count as differences.
  int exit_code() const;
};

/// "12 equal, 1 different": states that there are, the worst first.
std::string counts_text(const std::vector<EntryResult>& entries);

/// A few lines: counts and time, and the worst three.
std::string summary_text(const RunResults& results, const std::string& folder);

/// The same for a page of GitHub's: a table of what does not pass.
std::string summary_markdown(const RunResults& results);

/// docs/suite.schema.json describes it.
std::string results_json(const RunResults& results);

/// JUnit's XML, as build servers read it: a test case for each entry.
std::string junit_xml(const RunResults& results);

} // namespace refraster::suite
