#pragma once
// What the text of reports has in common.

#include "io/file/text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>

namespace refraster {

/// A line "label          content": contents of all lines stand in one column.
inline std::string report_line(const std::string& label, const std::string& content) {
  return format("%-14s %s\n", label.c_str(), content.c_str());
}

/// As printf's %.{digits}g in the locale "C".
inline std::string rounded_text(double x, int digits = 6) {
  std::array<char, 40> text;
  return {text.data(),
          std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::general, digits).ptr};
}

/// "12         0.0013 %". Cut, not rounded: 100 % means all.
inline std::string share_text(std::uint64_t count, std::uint64_t whole) {
  double percent = 100 * static_cast<double>(count) / static_cast<double>(whole);
  if (percent > 1) percent = std::floor(percent * 1e4) / 1e4;
  return format("%-10llu %s %%", static_cast<unsigned long long>(count), rounded_text(percent).c_str());
}

} // namespace refraster
