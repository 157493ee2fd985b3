#pragma once
// Text that becomes part of HTML or SVG.

#include "io/file/text.h"

#include <string>
#include <string_view>

namespace refraster {

/// With &, <, > and quotes as entities. What XML cannot hold, control characters and bytes that are no UTF-8, becomes
/// '?' and U+FFFD.
inline std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : as_utf8(one_line(text))) {
    if (c == '&') result += "&amp;";
    else if (c == '<') result += "&lt;";
    else if (c == '>') result += "&gt;";
    else if (c == '"') result += "&quot;";
    else result += c;
  }
  return result;
}

} // namespace refraster
