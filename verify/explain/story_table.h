#pragma once
// Lines of the story in columns.

#include "math/vec.h"

#include <string>
#include <string_view>
#include <vector>

namespace refraster::story {

inline constexpr std::size_t columns = 80; // of a terminal
inline constexpr std::size_t label_width = 33, number_width = 15;

/// As printf's %.{digits}{f, g or e} in the locale "C"; an infinity or NaN as a word.
std::string fixed(double x, int digits);
std::string general(double x, int digits);

/// For a column: 6 digits behind the point; of what is too small or too large for that, six digits and a power of ten.
std::string number(double x);

/// Blanks before it, or behind it, up to a width.
std::string right(std::string_view text, std::size_t width);
std::string left(std::string_view text, std::size_t width);

/// A label and numbers under each other: one line.
std::string row(std::string_view label, const std::vector<double>& numbers);
std::string row(std::string_view label, const Double3& v);
std::string row(std::string_view label, std::string_view text);

/// A heading, with an empty line before it; and one with names of three columns.
std::string heading(std::string_view text);
std::string heading_rgb(std::string_view text);

/// A sentence, in as many lines as it needs; the lines after the first stand `indent` further in.
std::string sentence(std::string_view text, std::size_t indent);

} // namespace refraster::story
