#pragma once
// Text of numbers, for reports.

#include <cstdio>
#include <string>

namespace refraster {

/// As printf.
template <class... Arguments>
std::string format(const char* pattern, Arguments... arguments) {
  const int length = std::snprintf(nullptr, 0, pattern, arguments...);
  std::string text(static_cast<std::size_t>(length), '\0');
  std::snprintf(text.data(), text.size() + 1, pattern, arguments...);
  return text;
}

} // namespace refraster
