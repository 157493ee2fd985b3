#include "raster/shadow/exact_crossing.h"

#include "raster/visibility/projective_polygon.h"

#include <algorithm>
#include <span>
#include <vector>

namespace refraster {
namespace {

using projective::Binary;
using projective::binary;
using projective::Integer;
using IntegerVec3 = std::array<Integer, 3>;

/// Numbers as integers, in units of the power of two of the smallest one's last bit. A zero has none of its own.
class Aligned {
public:
  void count(double x) {
    const Binary b = binary(x);
    if (b.mantissa == 0) return;
    exponent_ = any_ ? std::min(exponent_, b.exponent) : b.exponent;
    any_ = true;
  }
  void count(const Double3& v) { count(v.x), count(v.y), count(v.z); }

  Integer integer(double x) const {
    const Binary b = binary(x);
    return b.mantissa == 0 ? Integer() : Integer(b.mantissa) << (b.exponent - exponent_);
  }
  IntegerVec3 integer(const Double3& v) const { return {integer(v.x), integer(v.y), integer(v.z)}; }

private:
  int exponent_ = 0;
  bool any_ = false;
};

IntegerVec3 operator-(const IntegerVec3& a, const IntegerVec3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
IntegerVec3 operator*(const IntegerVec3& a, const Integer& s) {
  return {a[0] * s, a[1] * s, a[2] * s};
}
IntegerVec3 cross(const IntegerVec3& a, const IntegerVec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
int sign_of_dot(const IntegerVec3& a, const IntegerVec3& b) {
  const Integer dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  return dot.sign();
}

} // namespace

bool crosses_in_integers(const SurfacePoint& from, const LightPlace& to, const WorldTriangle& triangle) {
  const bool is_point = to.kind == LightPlace::Kind::point;
  Aligned length, of_weights, of_direction; // a common unit for all that is a place
  for (std::size_t k = 0; k < 3; ++k) {
    length.count(from.corner[k]), length.count(triangle[k]);
    of_weights.count(from.weight[k]);
  }
  (is_point ? length : of_direction).count(to.at);

  // The surface point is p / weight, and weight is above 0: what follows is times that, which changes no sign.
  IntegerVec3 p{};
  Integer weight;
  for (std::size_t k = 0; k < 3; ++k) {
    const Integer w = of_weights.integer(from.weight[k]);
    const IntegerVec3 corner = length.integer(from.corner[k]);
    for (std::size_t c = 0; c < 3; ++c) p[c] += corner[c] * w;
    weight += w;
  }
  const IntegerVec3 v[] = {length.integer(triangle[0]), length.integer(triangle[1]), length.integer(triangle[2])};
  const IntegerVec3 from_p[] = {v[0] * weight - p, v[1] * weight - p, v[2] * weight - p};

  // On which sides of the plane the two ends are. Going toward a light at infinity, that is the sign of what is left of
  // the plane's equation there.
  const IntegerVec3 normal = cross(v[1] - v[0], v[2] - v[0]);
  const int start = sign_of_dot(from_p[0], normal);
  if (start == 0) return false;
  const IntegerVec3 light = (is_point ? length : of_direction).integer(to.at);
  const int end = is_point ? sign_of_dot(v[0] - light, normal) : -sign_of_dot(light, normal);
  if (start * end >= 0) return false;

  // The line passes all edges on one side, or meets them.
  const IntegerVec3 way = is_point ? light * weight - p : light;
  bool any_left = false, any_right = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const int side = sign_of_dot(way, cross(from_p[(k + 1) % 3], from_p[(k + 2) % 3]));
    any_left |= side > 0, any_right |= side < 0;
  }
  return !(any_left && any_right);
}

} // namespace refraster
