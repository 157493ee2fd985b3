#pragma once
// Lines of an OBJ file, cut into words.

#include "io/mesh/obj_numbers.h"

#include <string_view>

namespace refraster {

inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

/// The next word of a line, which is taken off its front; empty at the end.
inline std::string_view take_word(std::string_view& line) {
  std::size_t begin = 0; // find_first_of is slow: it searches its list for every character
  while (begin < line.size() && is_blank(line[begin])) ++begin;
  std::size_t end = begin;
  while (end < line.size() && !is_blank(line[end])) ++end;
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

inline std::string_view trimmed(std::string_view line) {
  while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
  return line;
}

/// Where a comment begins in a line; its size if it has none. A '#' may also be that of 1.#QNAN.
inline std::size_t comment_in(std::string_view line) {
  for (std::size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1)) {
    std::size_t begin = at, end = at;
    while (begin > 0 && !is_blank(line[begin - 1])) --begin;
    while (end < line.size() && !is_blank(line[end])) ++end;
    if (!is_not_finite(line.substr(begin, end - begin))) return at;
  }
  return line.size();
}

} // namespace refraster
