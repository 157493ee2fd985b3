#include "io/file/text.h"

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

namespace {

/// Of the character that a text begins with; 0 if it begins with none.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const auto within = [&](std::size_t i, unsigned low, unsigned high) { return byte(i) >= low && byte(i) <= high; };
  const auto follows = [&](std::size_t i) { return within(i, 0x80, 0xbf); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead >= 0xc2 && lead <= 0xdf) return follows(1) ? 2 : 0;
  if (lead >= 0xe0 && lead <= 0xef) // not what two bytes say, not a surrogate
    return within(1, lead == 0xe0 ? 0xa0 : 0x80, lead == 0xed ? 0x9f : 0xbf) && follows(2) ? 3 : 0;
  if (lead >= 0xf0 && lead <= 0xf4) // not what three bytes say, not beyond U+10FFFF
    return within(1, lead == 0xf0 ? 0x90 : 0x80, lead == 0xf4 ? 0x8f : 0xbf) && follows(2) && follows(3) ? 4 : 0;
  return 0;
}

} // namespace

std::string as_utf8(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    result += length > 0 ? text.substr(0, length) : "\xef\xbf\xbd";
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

std::string counted(std::size_t count, std::string_view noun) {
  return std::to_string(count) + ' ' + std::string(noun) + (count == 1 ? "" : "s");
}

std::string alternatives(const std::vector<std::string>& choices) {
  std::string text;
  for (std::size_t i = 0; i < choices.size(); ++i)
    text += (i == 0 ? "" : i + 1 == choices.size() ? " or " : ", ") + choices[i];
  return text;
}

TextPlace place_in(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const std::string_view line = before.substr(before.rfind('\n') + 1); // npos + 1 is 0
  return {
      1 + static_cast<int>(std::count(before.begin(), before.end(), '\n')),
      1 + static_cast<int>(line.size() - static_cast<std::size_t>(std::count_if(line.begin(), line.end(), continues)))};
}

} // namespace refraster
