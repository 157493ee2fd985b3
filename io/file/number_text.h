#pragma once
// Numbers as text: correctly rounded, whatever the locale is.

#include <concepts>
#include <string_view>

namespace refraster {

enum class NumberText {
  good,
  not_a_number, // not a decimal number from its first character to its last
  not_finite,   // nan, inf, or beyond the largest finite F
};

/// Reads a whole word as a decimal number, `-1`, `+.5`, `2e-3`, rounded once to F; what is below the smallest F becomes
/// a zero of its sign.
template <std::floating_point F>
NumberText read_number(std::string_view word, F& value);

} // namespace refraster
