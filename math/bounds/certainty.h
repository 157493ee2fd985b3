#pragma once
// Masks of numbers that are known within bounds only.

#include "math/kit_namespace.h"

#include <algorithm>

namespace refraster::inline REFRASTER_KIT {

/// What a comparison of ranges says. It does not convert to bool: an `if` on it does not compile.
enum class Certainty { no, unknown, yes };

constexpr Certainty operator&(Certainty a, Certainty b) {
  return std::min(a, b);
}
constexpr Certainty operator|(Certainty a, Certainty b) {
  return std::max(a, b);
}
constexpr Certainty operator!(Certainty a) {
  return a == Certainty::yes ? Certainty::no : a == Certainty::no ? Certainty::yes : Certainty::unknown;
}
/// Whether it may be so.
constexpr bool any(Certainty a) {
  return a != Certainty::no;
}
/// Only what is certain counts.
constexpr int count_lanes(Certainty a) {
  return a == Certainty::yes ? 1 : 0;
}
/// Of two cases of which either may be.
constexpr Certainty join(Certainty a, Certainty b) {
  return a == b ? a : Certainty::unknown;
}

} // namespace refraster::inline REFRASTER_KIT
