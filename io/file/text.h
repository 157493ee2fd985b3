#pragma once
// Text of input files in messages, and of numbers in reports.

#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace refraster {

/// A word in quotes, cut where it is long; control characters are shown as '?'.
std::string in_quotes(std::string_view word);

/// What a library says, as one line: control characters become '?'.
std::string one_line(std::string_view message);

/// The text as UTF-8: each byte that is part of no character becomes U+FFFD. A path may hold any bytes, JSON may not.
/// Well-formed is what The Unicode Standard, table 3-7, says.
std::string as_utf8(std::string_view text);

/// What is left between the first and the last character that is not one of `blanks`; empty if there is none.
inline std::string_view trimmed(std::string_view text, std::string_view blanks) {
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

/// As printf.
template <class... Arguments>
std::string format(const char* pattern, Arguments... arguments) {
  const int length = std::snprintf(nullptr, 0, pattern, arguments...);
  std::string text(static_cast<std::size_t>(length), '\0');
  std::snprintf(text.data(), text.size() + 1, pattern, arguments...);
  return text;
}

/// "1 number", "2 numbers".
std::string counted(std::size_t count, std::string_view noun);

/// "1,048,576".
inline std::string with_commas(unsigned long long count) {
  std::string text = std::to_string(count);
  for (std::ptrdiff_t at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3)
    text.insert(static_cast<std::size_t>(at), ",");
  return text;
}

/// "a", "a or b", "a, b or c": what may stand somewhere. "" for none.
std::string alternatives(const std::vector<std::string>& choices);

/// A place in a text, counted from 1; columns are characters of UTF-8, not bytes.
struct TextPlace {
  int line, column;
};
TextPlace place_in(std::string_view text, std::size_t offset);

} // namespace refraster
