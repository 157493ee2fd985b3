#pragma once
// The textbook's way to a MERL table's coordinates, theta_h = acos(n.h) and theta_d = acos(i.h), for comparison.

#include "shading/merl_lookup.h"

#include <cmath>

namespace refraster::precision {

/// No fault of the arc cosine's: it is that of double, rounded once, and its argument is clamped, so that there is no
/// NaN. What is lost is lost in the cosine. w is that of the closed form.
template <class F>
MerlPoint<F> merl_point_by_arc_cosines(const Vec3<F>& n, const Vec3<F>& i, const Vec3<F>& o) {
  const Vec3<F> h = normalize(i + o);
  const auto angle = [](F cosine) {
    return static_cast<F>(std::acos(std::min(std::max(static_cast<double>(cosine), -1.0), 1.0)));
  };
  const F phi_d = half_difference(MerlAngles::closed, n, i, o).phi_d;
  return merl_point(HalfDifference<F>{angle(dot(n, h)), angle(dot(i, h)), phi_d});
}

} // namespace refraster::precision
