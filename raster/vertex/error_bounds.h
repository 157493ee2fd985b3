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

/// A quarter more than what the gallery and 20,000 random scenes showed; but the greatest error of a random scene's
/// world position is derived, since other seeds showed 10.5. A place that is snapped is the nearest point of the
/// lattice, unless it lies within the bound of `window x, y` of half way between two.
///
/// World position. In units of u = 2^-53 and to first order: sines and cosines are off by 0.75 ulp, 1.5 u of
/// themselves. An entry of Rx Ry Rz is made of at most two terms, sin a sin b cos c, off by three such errors and two
/// products (6.5 u), and cos a sin c (4 u), and their sum (1 u): 7.5 |sin a cos c| + 5 |cos a sin c| <= 7.5 in all. Of
/// a coordinate, sum r_j (s_j p_j) + t, such errors of r_j make 7.5 sum |s_j p_j| <= 7.5 sqrt(3) |Sp|; the products
/// with s_j and p_j and two sums make 4 sum |r_j s_j p_j| <= 4 |Sp|, since a row of a rotation has length 1; and t
/// takes part in two sums. 7.5 sqrt(3) + 4 = 17 of |t| + |Sp|.
inline constexpr VertexBound vertex_bounds[] = {
    {"world position", "gallery", {4.1, 1.8}},
    {"world normal", "gallery", {3.5, 2.1}},
    {"window x, y", "gallery", {1.3, 0.62}},
    {"window x, y, snapped", "gallery", {1.3, 0}},
    {"z / w", "gallery", {2.5, 1.3}},
    {"1 / w", "gallery", {2.8, 1.5}},
    {"world position", "random scenes", {17, 2.3}},
    {"world normal", "random scenes", {4.3, 2.2}},
    {"window x, y", "random scenes", {2.8, 1.1}},
    {"window x, y, snapped", "random scenes", {2.8, 0}},
    {"z / w", "random scenes", {2.6, 1.4}},
    {"1 / w", "random scenes", {3.4, 1.7}},
};

} // namespace refraster
