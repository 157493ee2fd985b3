#pragma once
// GGX: a surface of mirrors that lean as those of an ellipsoid do. How many lean how, and how many of them are seen.
// One source for the fragment function `microfacet` and for the tables that scenes/synthesis makes.

#include "math/constants.h"
#include "math/vec.h"
#include "shading/highlight_gap.h"

#include <numbers>

namespace refraster::inline REFRASTER_KIT {

/// What formulas need of alpha, the width of the density in (0, 1]: the slope at which it has fallen to a quarter.
template <class T>
struct GgxWidth {
  T squared;         // a = alpha^2
  T complement;      // 1 - a
  T squared_over_pi; // a / pi
};

template <Number T>
GgxWidth<T> ggx_width(double alpha) {
  return {as<T>(alpha * alpha), as<T>(1 - alpha * alpha), as<T>(alpha * alpha / std::numbers::pi)};
}
template <Number T>
GgxWidth<T> ggx_width(const T& alpha) {
  const T squared = square(alpha);
  return {squared, T(1) - squared, squared * constant<T>(constants::one_over_pi)};
}

/// a cos^2 theta_h + sin^2 theta_h, by those squares: >= a for a unit normal and a half vector.
template <Number T>
T ggx_spread(const T& squared_cosine, const T& squared_sine, const GgxWidth<T>& width) {
  return width.squared * squared_cosine + squared_sine;
}

/// The density of microfacet normals, D(h) = a / (pi spread^2). Walter et al., "Microfacet models for refraction
/// through rough surfaces", 2007, equation 33; Trowbridge, Reitz, "Average irregularity representation of a rough
/// surface for ray reflection", 1975.
template <Number T>
T ggx_density(const T& spread, const GgxWidth<T>& width) {
  return width.squared_over_pi / square(spread);
}

/// What both heights correlated leave of Smith's masking and shadowing is 2 n_i n_o over this:
///     n_o sqrt(a + (1 - a) n_i^2) + n_i sqrt(a + (1 - a) n_o^2).
/// Heitz, "Understanding the masking-shadowing function in microfacet-based BRDFs", 2014, equation 99.
template <Number T>
T smith_divisor(const T& n_i, const T& n_o, const GgxWidth<T>& width) {
  return n_o * sqrt(width.squared + width.complement * square(n_i)) +
         n_i * sqrt(width.squared + width.complement * square(n_o));
}

/// |n x (a + b)|^2. Of a and b whose sum is nearly along n little is left of each difference, and the square root of
/// the last place of 1 is the width of a highlight of alpha 1e-8: in double the components are those of the exact
/// difference, rounded once.
template <Number T>
T squared_cross_with_sum(const Vec3<T>& n, const Vec3<T>& a, const Vec3<T>& b) {
  if constexpr (SharpHighlights<T>) {
    const DoubleDouble<T> x = two_sum(a.x, b.x), y = two_sum(a.y, b.y), z = two_sum(a.z, b.z);
    const auto component = [](const T& n_i, const DoubleDouble<T>& s_j, const T& n_j, const DoubleDouble<T>& s_i) {
      const DoubleDouble<T> p = two_product(n_i, s_j.hi), q = two_product(n_j, s_i.hi), apart = two_sum(p.hi, -q.hi);
      return apart.hi + (apart.lo + ((p.lo - q.lo) + (n_i * s_j.lo - n_j * s_i.lo)));
    };
    return squared_length(Vec3<T>(component(n.y, z, n.z, y), component(n.z, x, n.x, z), component(n.x, y, n.y, x)));
  } else {
    return squared_length(cross(n, a + b));
  }
}

} // namespace refraster::inline REFRASTER_KIT
