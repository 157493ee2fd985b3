#pragma once
// The way from a point of a surface to a light, and whether it crosses a triangle.
//
// The answer is that of exact arithmetic on the numbers that are given, so that no tree, order, thread or instruction
// set has a part in it. Most triangles are decided in double, by a bound on its rounding errors; where that does not
// suffice, integers decide (raster/shadow/exact_crossing.h). After Woop, Benthin and Wald, "Watertight ray/triangle
// intersection", 2013, whose shear this is; theirs decides ties alone in more digits, and has an origin without error.

#include "math/scalar.h"
#include "math/vec.h"

#include <array>
#include <limits>
#include <optional>

namespace refraster {

/// A triangle's corners, world space.
using WorldTriangle = std::array<Double3, 3>;

/// A point of a triangle, by its weights, and not rounded: sum of weight[k] corner[k] over the sum of weights. So it
/// lies in the triangle, and never a rounding error before or behind it.
struct SurfacePoint {
  WorldTriangle corner;
  std::array<double, 3> weight{}; // none below 0
};

/// Where light comes from.
struct LightPlace {
  enum class Kind {
    point,    // `at` is its position: it shines on a surface along the segment between the two, without both ends
    direction // `at` is the direction to it, of any length: along the ray that leaves the surface that way
  };
  Kind kind = Kind::point;
  Double3 at{0}; // world space, finite
};

/// What the ray of one SurfacePoint to one LightPlace is computed with.
class ShadowRay {
public:
  /// Any numbers. Where no weight is above 0, or any number of the two is not finite, it crosses nothing.
  ShadowRay(const SurfacePoint& from, const LightPlace& to);

  bool is_defined() const { return defined_; }

  /// Whether the ray crosses the triangle: whether the two ends are on opposite sides of its plane, neither of them in
  /// it, and the line through them meets it, its edges and corners included. So a triangle in whose plane the surface
  /// point lies, that point's own above all, does not take its light; nor one without area, nor one that the ray runs
  /// along. Corners: finite. Exact.
  bool crosses(const WorldTriangle& triangle) const {
    if (const std::optional<bool> certain = crosses_certainly(triangle)) [[likely]]
      return *certain;
    return crosses_exactly(triangle);
  }

  /// The same in double; nothing where rounding errors leave it open. `edges`: see below.
  std::optional<bool> crosses_certainly(const WorldTriangle& triangle) const;
  /// The same in integers.
  bool crosses_exactly(const WorldTriangle& triangle) const;

  // For boxes. The ray without its surface point's rounding lies within `error` of that from `origin`, at the same
  // parameter t: 0 at the surface, 1 at a point light.

  const Double3& origin() const { return origin_; }
  const Double3& direction() const { return direction_; }
  double error() const { return error_; }
  double end() const { return to_.kind == LightPlace::Kind::point ? 1 : std::numeric_limits<double>::infinity(); }

private:
  SurfacePoint from_;
  LightPlace to_;
  bool defined_ = false;
  Double3 origin_{0};         // the surface point, rounded
  double error_ = 0;          // at most so far from it, in each coordinate
  Double3 direction_{0};      // from there to the light
  int x_ = 0, y_ = 1, z_ = 2; // axes: z is that of the greatest component of direction_
  double shear_x_ = 0, shear_y_ = 0;
  double shear_error_ = std::numeric_limits<double>::quiet_NaN(); // of both; not a number: nothing is certain
};

/// The unit roundoff of double: a result is off by at most so much of itself.
inline constexpr double unit_roundoff = 0x1p-53;

inline std::optional<bool> ShadowRay::crosses_certainly(const WorldTriangle& triangle) const {
  // Each bound below is derived in docs/shadows.md; each coefficient is larger than what is derived, for the roundings
  // of the bound itself. `tiny` is more than all that underflow takes away. What overflows makes the bound infinite or
  // not a number, and then no comparison holds.
  constexpr double u = unit_roundoff, tiny = std::numeric_limits<double>::min();
  double x[3], y[3], z[3], size = 0; // relative to the origin: z as it is, x and y sheared along the ray
  for (std::size_t k = 0; k < 3; ++k) {
    const Double3 p = triangle[k] - origin_;
    z[k] = p[z_];
    size = max(size, max(abs(p.x), max(abs(p.y), abs(p.z))));
    x[k] = p[x_] - shear_x_ * z[k];
    y[k] = p[y_] - shear_y_ * z[k];
  }
  const double off = 4 * error_ + (shear_error_ + 8 * u) * size + tiny; // of each x and y
  const double z_off = 2 * error_ + 2 * u * size;                       // of each z
  const auto all = [](const double(&v)[3], auto&& holds) { return holds(v[0]) && holds(v[1]) && holds(v[2]); };
  const auto above = [&](double least) { return [least](double v) { return v > least; }; };
  const auto below = [&](double most) { return [most](double v) { return v < most; }; };
  if (all(x, above(off)) || all(x, below(-off)) || all(y, above(off)) || all(y, below(-off))) return false;

  // Twice the areas that the ray's point in the sheared plane makes with the edges.
  const double area[3] = {x[2] * y[1] - y[2] * x[1], x[0] * y[2] - y[0] * x[2], x[1] * y[0] - y[1] * x[0]};
  const auto greatest = [](const double(&v)[3]) { return max(abs(v[0]), max(abs(v[1]), abs(v[2]))); };
  const double reach = max(greatest(x), greatest(y));
  const double area_off = 5 * reach * off + 3 * off * off + 5 * u * reach * reach + tiny;
  const auto any = [](const double(&v)[3], auto&& holds) { return holds(v[0]) || holds(v[1]) || holds(v[2]); };
  if (any(area, above(area_off)) && any(area, below(-area_off))) return false;
  const bool left = all(area, above(area_off)), right = all(area, below(-area_off));
  if (!left && !right) return std::nullopt;

  // The line crosses the triangle's inside. Where along it: height / sum of areas is the crossing's z, a mean of the
  // corners' with the areas as weights. Above `from`, less, as the sign of the sums says.
  const double forward = (direction_[z_] > 0) == left ? 1 : -1;
  const auto side = [&](const double(&from)[3], double from_off) -> std::optional<bool> {
    const double most = greatest(from);
    const double sum = area[0] * from[0] + area[1] * from[1] + area[2] * from[2];
    const double sum_off =
        4 * area_off * most + 8 * (reach * reach + area_off) * from_off + 20 * u * reach * reach * most + tiny;
    if (!(abs(sum) > sum_off)) return std::nullopt;
    return sum * forward > 0;
  };
  const std::optional<bool> after_start = side(z, z_off);
  if (!after_start || !*after_start) return after_start;
  if (to_.kind == LightPlace::Kind::direction) return true;
  double to_light[3];
  for (std::size_t k = 0; k < 3; ++k) to_light[k] = triangle[k][z_] - to_.at[z_];
  const std::optional<bool> after_end = side(to_light, 2 * u * greatest(to_light));
  if (!after_end) return std::nullopt;
  return !*after_end;
}

} // namespace refraster
