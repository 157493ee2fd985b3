#pragma once
// How far what the vertex stage stores is from exact arithmetic on the scene's numbers. docs/precision.md says what is
// measured, on what, and how; tests/system/precision measures again and compares.

#include "math/elementary/ulp_bound.h"

#include <string_view>

namespace refraster {

/// One value that is stored, on one kind of scenes. In units of 2^-53 of the sum of the magnitudes of what it is made
/// from; so where nothing cancels, of a last place of the value itself.
struct VertexBound {
  std::string_view stored, scenes; // what is stored; of the gallery, or of the soak test's generator
  UlpBound units;
};

/// A quarter more than what the gallery and 20,000 random scenes showed. A place that is snapped is the nearest point
/// of the lattice, unless it lies within the bound of `window x, y` of half way between two.
inline constexpr VertexBound vertex_bounds[] = {
    {"world position", "gallery", {4.1, 1.8}},
    {"world normal", "gallery", {3.5, 2.1}},
    {"window x, y", "gallery", {1.3, 0.62}},
    {"window x, y, snapped", "gallery", {1.3, 0}},
    {"z / w", "gallery", {2.5, 1.3}},
    {"1 / w", "gallery", {2.8, 1.5}},
    {"world position", "random scenes", {4.3, 2.3}},
    {"world normal", "random scenes", {4.3, 2.2}},
    {"window x, y", "random scenes", {2.8, 1.1}},
    {"window x, y, snapped", "random scenes", {2.8, 0}},
    {"z / w", "random scenes", {2.6, 1.4}},
    {"1 / w", "random scenes", {3.4, 1.7}},
};

} // namespace refraster
