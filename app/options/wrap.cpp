#include "app/options/wrap.h"

#include "app/options/option.h"

#include <algorithm>
#include <cstdlib>

#include <sys/ioctl.h>

namespace refraster {

int columns_of(std::string_view text) {
  const auto begins_character = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; };
  return static_cast<int>(std::count_if(text.begin(), text.end(), begins_character));
}

std::vector<std::string> wrapped(std::string_view text, int width) {
  std::vector<std::string> lines(1);
  for (const std::string_view word : split(text, ' ')) {
    if (word.empty()) continue;
    if (!lines.back().empty()) {
      if (columns_of(lines.back()) + 1 + columns_of(word) > width) lines.emplace_back();
      else lines.back() += ' ';
    }
    lines.back() += word;
  }
  return lines;
}

int terminal_width(int descriptor) {
  constexpr int narrowest = 40, widest = 120, unknown = 80;
  int columns = 0;
  if (const char* const variable = std::getenv("COLUMNS")) columns = number_from<int>(variable).value_or(0);
  winsize size{};
  if (columns <= 0 && ioctl(descriptor, TIOCGWINSZ, &size) == 0) columns = size.ws_col;
  return columns <= 0 ? unknown : std::clamp(columns, narrowest, widest);
}

} // namespace refraster
