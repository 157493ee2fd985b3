#pragma once
// Text that becomes part of HTML or SVG.

#include <string>
#include <string_view>

namespace refraster::bench {

/// With &, <, > and quotes as entities.
inline std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') result += "&amp;";
    else if (c == '<') result += "&lt;";
    else if (c == '>') result += "&gt;";
    else if (c == '"') result += "&quot;";
    else result += c;
  }
  return result;
}

} // namespace refraster::bench
