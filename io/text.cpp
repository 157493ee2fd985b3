#include "io/text.h"

#include <algorithm>

namespace refraster {
namespace {
/// Whether a byte is within a character of UTF-8, behind its first byte.
bool continues(char c) {
  return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}
} // namespace

std::string in_quotes(std::string_view word) {
  constexpr std::size_t most = 60;
  std::size_t shown = word.size();
  if (shown > most)
    for (shown = most; shown > 0 && continues(word[shown]);) --shown;
  std::string result = one_line(word.substr(0, shown));
  result.insert(result.begin(), '"');
  return result.append(shown < word.size() ? "…\"" : "\"");
}

std::string one_line(std::string_view message) {
  std::string result(message);
  for (char& c : result)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return result;
}

std::string counted(std::size_t count, std::string_view noun) {
  return std::to_string(count) + ' ' + std::string(noun) + (count == 1 ? "" : "s");
}

TextPlace place_in(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const std::string_view line = before.substr(before.rfind('\n') + 1); // npos + 1 is 0
  return {
      1 + static_cast<int>(std::count(before.begin(), before.end(), '\n')),
      1 + static_cast<int>(line.size() - static_cast<std::size_t>(std::count_if(line.begin(), line.end(), continues)))};
}

} // namespace refraster
