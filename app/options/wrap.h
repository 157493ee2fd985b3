#pragma once
// Text in lines.

#include <string>
#include <string_view>
#include <vector>

namespace refraster {

/// Columns that a text in UTF-8 takes: one for each character. That is right for what this program says, whose help has
/// neither wide nor combining characters.
int columns_of(std::string_view text);

/// The words of the text in lines of at most `width` columns, without blanks at their ends. Words are what stands
/// between blanks and are never broken: one that is wider than `width` has a line of its own. At least one line.
std::vector<std::string> wrapped(std::string_view text, int width);

/// Columns to write in, for help on a file descriptor: what the variable COLUMNS says, else the terminal, else 80. At
/// most 120, beyond which lines are hard to read, and at least 40.
int terminal_width(int descriptor);

} // namespace refraster
