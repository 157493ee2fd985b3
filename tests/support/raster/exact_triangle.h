#pragma once
// What a triangle is at a sample, in rational numbers. Two ways, neither of which knows edge functions: in three
// dimensions, where a ray meets the triangle; and in the window, from the snapped corners, by Cramer's rule.

#include "raster/vertex/transform.h"
#include "tests/support/raster/window_vertex.h"
#include "tests/support/ulp.h"

#include <array>
#include <optional>

#include <boost/multiprecision/gmp.hpp>

namespace refraster::test {

using Integer = boost::multiprecision::mpz_int;
using Rational = boost::multiprecision::mpq_rational;
using RationalVec3 = std::array<Rational, 3>;

inline Mpfr exact(const Rational& x) {
  return Mpfr(boost::multiprecision::numerator(x)) / Mpfr(boost::multiprecision::denominator(x));
}

template <class V>
RationalVec3 rational(const V& v) {
  return {Rational(v.x), Rational(v.y), Rational(v.z)};
}

inline Rational determinant(const RationalVec3& a, const RationalVec3& b, const RationalVec3& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// The lambda with p = lambda_0 a + lambda_1 b + lambda_2 c; nothing where a, b, c lie in one plane with the origin.
inline std::optional<RationalVec3> combination(const RationalVec3& p, const RationalVec3& a, const RationalVec3& b,
                                               const RationalVec3& c) {
  const Rational whole = determinant(a, b, c);
  if (whole == 0) return std::nullopt;
  return RationalVec3{determinant(p, b, c) / whole, determinant(a, p, c) / whole, determinant(a, b, p) / whole};
}

enum class Meets { inside, border, outside };

/// inside: all weights positive.
inline Meets meets(const RationalVec3& weight) {
  if (weight[0] < 0 || weight[1] < 0 || weight[2] < 0) return Meets::outside;
  return weight[0] == 0 || weight[1] == 0 || weight[2] == 0 ? Meets::border : Meets::inside;
}

/// Where the ray from the origin along `direction` meets the plane of a, b and c, and how.
struct RayHit {
  RationalVec3 point;
  Meets how = Meets::outside;
};

/// Nothing where the ray lies in the plane or never meets it going forward.
inline std::optional<RayHit> ray_hit(const RationalVec3& direction, const RationalVec3& a, const RationalVec3& b,
                                     const RationalVec3& c) {
  const auto weight = combination(direction, a, b, c);
  if (!weight) return std::nullopt;
  // direction / sum is a point of the plane: its weights add up to 1.
  const Rational sum = (*weight)[0] + (*weight)[1] + (*weight)[2];
  if (sum <= 0) return std::nullopt;
  return RayHit{{direction[0] / sum, direction[1] / sum, direction[2] / sum}, meets(*weight)};
}

/// A triangle in front of the eye as the pixel rules define it: corners within the guard band stand on the lattice of
/// subpixels where window_vertex puts them, with their own w; those beyond it where their clip coordinates say.
class ExactTriangle {
public:
  struct At {
    RationalVec3 weight; // of each corner: attribute f is the sum of weight_k f_k; they add up to 1
    Rational depth;      // z / w
    Meets how = Meets::outside;
  };

  /// w > 0 at every corner.
  ExactTriangle(const std::array<Double4, 3>& clip, int width, int height) {
    for (std::size_t k = 0; k < 3; ++k) {
      const WindowVertex v = window_vertex(clip[k], width, height);
      const Rational x(clip[k].x), y(clip[k].y), w(clip[k].w);
      is_snapped_[k] = !(v.outcode & outcode::unsnapped);
      z_[k] = Rational(clip[k].z), w_[k] = w;
      const Rational half_width(128 * width), half_height(128 * height);
      if (is_snapped_[k]) point_[k] = {Rational(v.x), Rational(v.y), Rational(1)};
      else point_[k] = {(x + w) * half_width, (w - y) * half_height, w};
    }
  }

  /// At a point of the window, in subpixels. Nothing if the triangle has no area.
  std::optional<At> at(const Rational& x, const Rational& y) const {
    const auto lambda = combination({x, y, Rational(1)}, point_[0], point_[1], point_[2]);
    if (!lambda) return std::nullopt;
    At result;
    result.how = meets(*lambda);
    Rational sum = 0, z = 0, w = 0;
    RationalVec3 mu;
    for (std::size_t k = 0; k < 3; ++k) {
      mu[k] = is_snapped_[k] ? Rational((*lambda)[k] / w_[k]) : (*lambda)[k];
      sum += mu[k], z += mu[k] * z_[k], w += mu[k] * w_[k];
    }
    if (sum == 0 || w == 0) return std::nullopt;
    for (std::size_t k = 0; k < 3; ++k) result.weight[k] = mu[k] / sum;
    result.depth = z / w;
    return result;
  }

  bool has_area() const { return determinant(point_[0], point_[1], point_[2]) != 0; }

private:
  std::array<RationalVec3, 3> point_;
  RationalVec3 z_, w_;
  std::array<bool, 3> is_snapped_{};
};

} // namespace refraster::test
