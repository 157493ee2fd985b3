#pragma once
// A table of a page.

#include "io/html/markup.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace refraster {

/// Rows of cells; the first `left` columns hold words, the others numbers. Without any heading there is no row of them.
class HtmlTable {
public:
  HtmlTable(const std::vector<std::string>& headings, std::size_t left) : left_(left) {
    html_ = "<div class=\"wide\"><table>\n";
    if (std::all_of(headings.begin(), headings.end(), [](const std::string& heading) { return heading.empty(); }))
      return;
    html_ += "<tr>";
    for (std::size_t i = 0; i < headings.size(); ++i) html_ += cell("th", headings[i], i);
    html_ += "</tr>\n";
  }
  /// Whether a rule is drawn above a row.
  enum class Group { first, same };
  void add(const std::vector<std::string>& cells, Group group = Group::same) {
    html_ += group == Group::first ? "<tr class=\"first\">" : "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i) html_ += cell("td", cells[i], i);
    html_ += "</tr>\n";
    ++rows_;
  }
  /// Empty if there is no row.
  std::string html() const { return rows_ == 0 ? "" : html_ + "</table></div>\n"; }

private:
  std::string cell(const char* element, const std::string& words, std::size_t i) const {
    return std::string("<") + element + (i < left_ ? " class=\"left\">" : ">") + escaped(words) + "</" + element + ">";
  }
  std::size_t left_, rows_ = 0;
  std::string html_;
};

} // namespace refraster
