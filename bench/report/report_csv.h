#pragma once
// The report of a run for spreadsheets: docs/bench.md.

#include "bench/measure/results.h"

#include <string>
#include <string_view>
#include <vector>

namespace refraster::bench {

/// A table as RFC 4180 has it, but for line ends, which are line feeds: a row of headings, then rows of as many cells.
/// Numbers read back as the same double; where there is none, a cell is empty.
struct CsvTable {
  std::string_view file_name;
  std::string text;
};

/// The names of the files, in the order of csv_tables.
inline constexpr std::string_view csv_file_names[] = {"frames.csv", "split.csv",   "commands.csv", "costs.csv",
                                                      "errors.csv", "scaling.csv", "machine.csv"};

/// All tables; one of which there is nothing to say has its headings only.
std::vector<CsvTable> csv_tables(const Run& run);

} // namespace refraster::bench
