#pragma once
// Tables of numbers as text: CSV.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace refraster {

/// Rows of numbers under columns that have names.
struct NumberTable {
  std::string file;                 // named in messages
  std::vector<std::string> columns; // small letters, without blanks around them
  std::vector<double> values;       // row by row; may be NaN or infinite
  std::vector<int> lines;           // of each row, from 1

  std::size_t rows() const { return lines.size(); }
  double at(std::size_t row, std::size_t column) const { return values[row * columns.size() + column]; }
  /// The column of this name; nothing if there is none.
  std::optional<std::size_t> column(std::string_view name) const;
};

/// Reads a text whose first line names the columns. Between cells stand commas, semicolons or tabs, whichever the first
/// line has, or else blanks. Lines that begin with '#' and empty ones are left out. Numbers are decimal with a point,
/// or nan, inf; cells may be in quotes. Throws InputError with all faults: no columns, a name twice, a row of another
/// number of cells, a cell that is no number, a text that is none.
NumberTable number_table(std::string file, std::string_view text);

/// The same of a file of at most limit::csv_bytes.
NumberTable read_number_table(const std::string& path);

} // namespace refraster
