#pragma once
// The colour of a surface, from the formulas of docs/conventions.md as a textbook has them: long double, the C
// library's pow and acos, one light after the other.

#include "tests/system/scenes/slow_visibility.h"

namespace refraster::slow {

struct Shaded {
  Vec radiance;  // toward the eye
  Vec magnitude; // the sum of what was added, with white for the texture: rounding errors are in proportion to it
};

/// Nothing for lookups that are not implemented here: those on logarithms.
std::optional<Shaded> shaded(const Scene& scene, const Seen& seen);

} // namespace refraster::slow
