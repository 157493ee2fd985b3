#pragma once
// The normal of a polygon and the angles at its corners, in numbers of one polygon, or of several side by side: each
// has the same bits as alone.

#include "math/elementary.h"
#include "math/vec.h"

#include <cmath>
#include <limits>
#include <span>

namespace refraster {

// Half a unit in the last place of 1: one rounding in double, in proportion to the result.
inline constexpr double rounding = 0x1p-53;
// Of a vector made unit: each component is within 3 units in the last place (scale exact, root, reciprocal and product
// half a unit each and a sum), 6 roundings, and there are three.
inline constexpr double unit_error = 6 * 1.7320508075688773 * rounding;
inline constexpr double pi = 3.14159265358979323846;

/// How far rounding to float may have moved a point: half a unit in the last place of each coordinate.
template <class T>
T rounding_of(const Vec3<T>& point) {
  // Half a unit in the last place of a coordinate is 2^-24 of it; of a subnormal one, half of the smallest float, and
  // of three of these less than that.
  return T(0x1p-24) * length(point) + T(static_cast<double>(std::numeric_limits<float>::denorm_min()));
}

/// Along a polygon's normal, and twice its area long. `at(i)`: its corners, of which there are n.
template <class T, class At>
Vec3<T> area_vector_of(std::size_t n, const At& at) {
  const Vec3<T> origin = at(0);
  Vec3<T> sum(T(0.0));
  for (std::size_t i = 1; i + 1 < n; ++i) sum = sum + cross(Vec3<T>(at(i) - origin), Vec3<T>(at(i + 1) - origin));
  return sum;
}

/// The normal of a polygon, by Newell's sum of its corners' cross products.
template <class T>
struct FaceNormalOf {
  Vec3<T> n; // unit; 0 where it has no area beyond what rounding may have made of one
  T error;   // how far n may be from the normal of the file's polygon, whose coordinates were rounded; 0 where n is
  T arithmetic_error; // how far n may be from the normal of the polygon as it is; likewise
};

/// `roundings`: rounding_of each corner.
template <class T>
FaceNormalOf<T> face_normal(std::span<const Vec3<T>> polygon, std::span<const T> roundings) {
  const std::size_t n = polygon.size();
  const Vec3<T> area = area_vector_of<T>(n, [&](std::size_t i) { return polygon[i]; });
  // A product in the sum has passed a rounding in each of two differences, one of its own, one where it is subtracted,
  // and one for each of n - 3 additions; one more for this bound's own sum.
  Vec3<T> products(T(0.0));
  T moved(0); // to first order, by the rounding of each corner: along it the sum changes by the diagonal across
  const auto magnitudes = [](const Vec3<T>& a) { return Vec3<T>(abs(a.x), abs(a.y), abs(a.z)); };
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3<T>& next = polygon[(i + 1) % n];
    moved = moved + roundings[i] * length(next - polygon[(i + n - 1) % n]);
    if (i == 0 || i + 1 == n) continue;
    const Vec3<T> a = magnitudes(polygon[i] - polygon[0]), b = magnitudes(next - polygon[0]);
    products = products + Vec3<T>(a.y * b.z + a.z * b.y, a.z * b.x + a.x * b.z, a.x * b.y + a.y * b.x);
  }
  const T arithmetic = T(static_cast<double>(n + 2) * rounding) * length(products), size = length(area);
  const MaskOf<T> is_one = size > moved + arithmetic;
  // |a/|a| - b/|b|| <= 2 |a - b| / |a|.
  return {select<T>(is_one, normalize(area), Vec3<T>(T(0.0))),
          select(is_one, T(2) * (moved + arithmetic) / size + T(unit_error), T(0)),
          select(is_one, T(2) * arithmetic / size + T(unit_error), T(0))};
}

/// The angle inside a polygon at a corner, in [0, 2 pi), and how far off it may be.
template <class T>
struct InnerAngle {
  T radians, error;
};

/// A corner of a polygon: place, and its rounding_of.
template <class T>
struct RoundedPoint {
  const Vec3<T>& at;
  const T& rounding;
};

/// An edge of a polygon, seen from one of its ends: from the other one it has the opposite direction, bit for bit.
template <class T>
struct EdgeDirection {
  Vec3<T> unit;
  T error;  // how far it may be off
  T length; // of the edge

  EdgeDirection reversed() const { return {Vec3<T>(T(0.0) - unit.x, T(0.0) - unit.y, T(0.0) - unit.z), error, length}; }
};

template <class T>
EdgeDirection<T> edge_direction(const RoundedPoint<T>& from, const RoundedPoint<T>& to) {
  const Vec3<T> edge = to.at - from.at;
  const T size = length(edge);
  return {normalize(edge), T(2) * (from.rounding + to.rounding) / size + T(unit_error), size};
}

/// From the edge to the next corner round the normal to the edge to the corner before, both seen from this one.
template <class T>
InnerAngle<T> inner_angle(const EdgeDirection<T>& to_next, const EdgeDirection<T>& to_before,
                          const FaceNormalOf<T>& face) {
  const Vec3<T>&a = to_next.unit, &b = to_before.unit;
  const Vec3<T> across = cross(a, b);
  const T edges = to_next.error + to_before.error;
  // Cross product, dot products: 7 roundings for the sine, 3 for the cosine. Then the arc tangent and one addition, of
  // angles up to 2 pi, whose unit in the last place is 8 roundings.
  const T error = edges + T((10 + 8 * (atan2_error<double>.max + 0.5)) * rounding);
  const T cosine = dot(a, b), sine = dot(face.n, across);
  // An edge that runs back along the one before is no whole turn.
  const MaskOf<T> is_straight = abs(sine) <= edges + face.error;
  const T angle = atan2(select(is_straight, abs(sine), sine), cosine);
  return {select(angle < T(0), angle + T(2 * pi), angle), error};
}

} // namespace refraster
