#pragma once
// Text of numbers, for tables and pictures.

#include "io/file/text.h"

#include <string>

namespace refraster::bench {

/// "1,048,576".
inline std::string with_commas(unsigned long long count) {
  std::string text = std::to_string(count);
  for (std::ptrdiff_t at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3)
    text.insert(static_cast<std::size_t>(at), ",");
  return text;
}

} // namespace refraster::bench
