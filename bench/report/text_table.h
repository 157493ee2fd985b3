#pragma once
// Columns of text.

#include <string>
#include <vector>

namespace refraster::bench {

/// Rows of cells under a row of headings; the first column stands to the left, the others, numbers, to the right.
class TextTable {
public:
  explicit TextTable(std::vector<std::string> headings) : rows_{std::move(headings)} {}
  /// As many cells as there are headings.
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  /// Each row a line.
  std::string text() const;

private:
  std::vector<std::vector<std::string>> rows_;
};

} // namespace refraster::bench
