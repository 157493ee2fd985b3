#include "raster/shadow/shadow_ray.h"

#include "raster/shadow/exact_crossing.h"

namespace refraster {
namespace {

bool is_finite(double x) {
  return abs(x) <= std::numeric_limits<double>::max();
}
bool is_finite(const Double3& v) {
  return is_finite(v.x) && is_finite(v.y) && is_finite(v.z);
}
double greatest(const Double3& v) {
  return max(abs(v.x), max(abs(v.y), abs(v.z)));
}

} // namespace

ShadowRay::ShadowRay(const SurfacePoint& from, const LightPlace& to) : from_(from), to_(to) {
  constexpr double u = unit_roundoff;
  const auto& weight = from.weight;
  const auto& corner = from.corner;
  const double heaviest = max(weight[0], max(weight[1], weight[2]));
  defined_ = heaviest > 0 && is_finite(to.at) && (to.kind == LightPlace::Kind::point || greatest(to.at) > 0);
  for (std::size_t k = 0; k < 3; ++k) defined_ = defined_ && is_finite(weight[k]) && is_finite(corner[k]);
  if (!defined_) return;

  // Weights below 1/2 by a power of two: no product with a coordinate within 2^1022 and no sum of three overflows, and
  // the sum of weights is not so small that underflow counts. Only the rounded point is made of these.
  const double scale = 0.25 * reciprocal_binade(heaviest);
  Double3 sum(0);
  double weights = 0, largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    sum += corner[k] * (weight[k] * scale);
    weights += weight[k] * scale;
    largest = max(largest, greatest(corner[k]));
  }
  origin_ = sum / weights;
  // Products, two sums above and two below the line and the quotient: 7 roundings of a mean, no larger than `largest`.
  // Of weights that are all subnormal nothing is known, and integers decide.
  error_ = heaviest < std::numeric_limits<double>::min() ? std::numeric_limits<double>::infinity()
                                                         : 12 * u * largest + std::numeric_limits<double>::min();
  direction_ = to.kind == LightPlace::Kind::point ? to.at - origin_ : to.at;

  const Double3 size(abs(direction_.x), abs(direction_.y), abs(direction_.z));
  z_ = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  x_ = (z_ + 1) % 3, y_ = (z_ + 2) % 3;
  const double length = size[z_];
  shear_x_ = direction_[x_] / direction_[z_], shear_y_ = direction_[y_] / direction_[z_];
  // How far each component of the direction may be off, in units of the greatest.
  const double relative = to.kind == LightPlace::Kind::point ? error_ / length + 2 * u : 0;
  if (relative <= 0.25 && is_finite(length)) shear_error_ = 4 * relative + 2 * u;
}

bool ShadowRay::crosses_exactly(const WorldTriangle& triangle) const {
  return defined_ && crosses_in_integers(from_, to_, triangle);
}

} // namespace refraster
