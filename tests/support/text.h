#pragma once
// What tests ask of texts.

#include <sstream>
#include <string>
#include <string_view>

namespace refraster {

/// Whether `part` is somewhere in `text`.
inline bool holds(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

/// Its words, with one blank between two.
inline std::string in_one_line(const std::string& text) {
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;) line += (line.empty() ? "" : " ") + word;
  return line;
}

} // namespace refraster
