#include "io/csv/number_table.h"

#include "io/file/fault_list.h"
#include "io/file/input_file.h"
#include "io/file/limits.h"
#include "io/file/number_text.h"
#include "io/file/text.h"
#include "io/file/text_kind.h"

#include <algorithm>
#include <cctype>
#include <limits>

namespace refraster {
namespace {

constexpr std::string_view blanks = " \t\r";

/// Cells in quotes hold numbers or names: neither has a separator in it.
std::string_view without_quotes(std::string_view cell) {
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
    return trimmed(cell.substr(1, cell.size() - 2), blanks);
  return cell;
}

char separator_of(std::string_view header) {
  for (const char separator : {',', ';', '\t'})
    if (header.find(separator) != std::string_view::npos) return separator;
  return ' ';
}

/// Calls use(cell) for each; several blanks are one separator.
template <class Use>
void for_each_cell(std::string_view line, char separator, const Use& use) {
  for (std::size_t start = 0; start <= line.size();) {
    const std::size_t end = std::min(line.find(separator, start), line.size());
    use(without_quotes(trimmed(line.substr(start, end - start), blanks)));
    start = separator == ' ' ? std::min(line.find_first_not_of(" \t", end), line.size()) : end + 1;
    if (separator == ' ' && start == line.size()) break;
  }
}

/// "nan", "-inf", "1e999".
double not_finite(std::string_view cell) {
  const std::string_view unsigned_cell = cell.substr(cell.find_first_not_of("+-"));
  if (std::tolower(static_cast<unsigned char>(unsigned_cell.front())) == 'n')
    return std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  return cell.front() == '-' ? -infinity : infinity;
}

class TableReader {
public:
  explicit TableReader(NumberTable& table) : table_(table) {}

  void read(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3); // the byte order mark of UTF-8
    for (std::size_t start = 0; start < text.size();) {
      const std::size_t end = std::min(text.find('\n', start), text.size());
      ++line_;
      const std::string_view line = trimmed(text.substr(start, end - start), blanks);
      start = end + 1;
      if (line.empty() || line.front() == '#') continue;
      if (table_.columns.empty()) read_header(line);
      else read_row(line);
    }
    if (table_.columns.empty()) fault(0, "", "no line", "a first line with the names of columns");
    faults_.throw_if_any();
  }

private:
  void read_header(std::string_view line) {
    separator_ = separator_of(line);
    for_each_cell(line, separator_, [&](std::string_view cell) {
      std::string name(cell);
      std::ranges::transform(name, name.begin(),
                             [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
      if (table_.column(name)) fault(line_, "", "two columns " + in_quotes(name), "each name once");
      table_.columns.push_back(std::move(name));
    });
  }

  void read_row(std::string_view line) {
    std::size_t cells = 0;
    for_each_cell(line, separator_, [&](std::string_view cell) {
      if (cells < table_.columns.size()) table_.values.push_back(number_of(cell, table_.columns[cells]));
      ++cells;
    });
    if (cells != table_.columns.size())
      fault(line_, "", counted(cells, "cell"), std::to_string(table_.columns.size()) + ", as the first line has");
    table_.values.resize((table_.rows() + 1) * table_.columns.size());
    table_.lines.push_back(line_);
  }

  double number_of(std::string_view cell, const std::string& column) {
    double number = 0;
    switch (read_number(cell, number)) {
    case NumberText::good:
      return number;
    case NumberText::not_finite:
      return not_finite(cell);
    case NumberText::not_a_number:
      break;
    }
    fault(line_, column, cell.empty() ? "nothing" : in_quotes(cell), "a number");
    return 0;
  }

  void fault(int line, const std::string& column, std::string found, std::string expected) {
    faults_.add({table_.file, line, 0, column, std::move(found), std::move(expected)});
  }

  NumberTable& table_;
  FaultList faults_;
  int line_ = 0;
  char separator_ = ',';
};

} // namespace

std::optional<std::size_t> NumberTable::column(std::string_view name) const {
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns.begin());
}

NumberTable number_table(std::string file, std::string_view text) {
  NumberTable table{.file = std::move(file), .columns = {}, .values = {}, .lines = {}};
  if (const TextKind kind = text_kind(text); kind != TextKind::plain)
    throw InputError(InputFault{table.file, 0, 0, "", std::string(name_of(kind)), "a table of numbers as text"});
  TableReader(table).read(text);
  return table;
}

NumberTable read_number_table(const std::string& path) {
  return number_table(path, read_file(path, "a table of numbers", limit::csv_bytes.value));
}

} // namespace refraster
