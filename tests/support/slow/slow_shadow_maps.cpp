#include "tests/support/slow/slow_shadow_maps.h"

#include "tests/support/slow/slow_vertices.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace refraster::slow {
namespace {

constexpr Real infinity = std::numeric_limits<Real>::infinity();

// Double is good to some 2^-48 of what is added up where a surface is placed in the map; the doubt is far more.
constexpr Real doubt = 0x1p-36L;
/// A float in [0, 1] is off by at most half of 2^-24.
constexpr Real stored_doubt = 0x1p-24L;
/// How far the ray of a texel may be off, in texels: corners are snapped to the nearest 1/256, each axis for itself.
constexpr Real snap = 1 / Real(256);
/// Of the product of three vectors' greatest coordinates, by how much rounding may change their determinant. With u,
/// half of epsilon, a coordinate in a face is off by at most 8 u of the greatest in the world, of which it is at most
/// the root of 3; a difference of two products by 2 (2 * 8 + 2) u, and three products with a third by 3 (36 + 8 + 3) u,
/// of three such roots: less than 2^10 u.
constexpr Real rounded = 0x1p10L * std::numeric_limits<Real>::epsilon() / 2;

Real component(Vec v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/// Along an axis of the world: "+x" is 0, "-x" 1 and so on.
Vec axis_vector(int number, Real sign) {
  return {number == 0 ? sign : 0, number == 1 ? sign : 0, number == 2 ? sign : 0};
}

bool finite(Vec v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

Real size(Vec v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

} // namespace

void SlowShadowMap::start(const Scene& scene, const ShadowMap& map) {
  map_ = map;
  const Viewer viewer(scene.camera, 1, 1);
  low_ = {infinity, infinity, infinity}, high_ = low_ * Real(-1);
  for (const Object& object : scene.objects) {
    const std::vector<Corner> corners = corners_of(object, viewer);
    for (const Corner& corner : corners) {
      const Vec p = corner.position;
      if (!finite(p)) continue;
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y), std::max(high_.z, p.z)};
    }
    for (const auto& v : object.mesh->triangles)
      triangles_.push_back({corners[v[0]].position, corners[v[1]].position, corners[v[2]].position});
  }
  if (!(low_.x <= high_.x)) low_ = high_ = {};
}

SlowShadowMap::SlowShadowMap(const Scene& scene, const PointLight& light) : is_point_(true) {
  start(scene, light.shadow.map);
  origin_ = vec(light.position);
  Real farthest = 0, nearest = 0;
  if (!triangles_.empty() || size(low_) + size(high_) > 0)
    for (int c = 0; c < 3; ++c) {
      const Real below = component(low_, c) - component(origin_, c),
                 above = component(high_, c) - component(origin_, c);
      farthest = std::max({farthest, -below, above}), nearest = std::max({nearest, below, -above});
    }
  far_ = (farthest > 0 ? farthest : 1) * (1 + 2 / Real(map_.size));
  near_ = map_.near > 0 ? real(map_.near) : std::max(far_ / 256, nearest / 2);
  far_ = std::max(far_, 2 * near_);
}

SlowShadowMap::SlowShadowMap(const Scene& scene, const DirectionLight& light) {
  start(scene, light.shadow.map);
  const Vec ahead = unit(vec(light.direction)), a{std::abs(ahead.x), std::abs(ahead.y), std::abs(ahead.z)};
  const int least = a.x <= a.y && a.x <= a.z ? 0 : a.y <= a.z ? 1 : 2;
  axes_.ahead = ahead;
  axes_.right = unit(cross(ahead, axis_vector(least, 1)));
  axes_.up = cross(axes_.right, ahead);
  origin_ = (low_ + high_) * Real(0.5L);
  const Vec extent = (high_ - low_) * Real(0.5L);
  const auto reach = [&](Vec axis) {
    return std::abs(axis.x) * extent.x + std::abs(axis.y) * extent.y + std::abs(axis.z) * extent.z;
  };
  const Real across = std::max(reach(axes_.right), reach(axes_.up)), texels = map_.size;
  half_ = (across > 0 ? across : 1) * texels / (texels - 2);
  far_ = reach(ahead) + 2 * half_ / texels, near_ = -far_;
}

SlowShadowMap::Axes SlowShadowMap::axes(std::size_t face) const {
  if (!is_point_) return axes_;
  // OpenGL 4.6, table 8.19.
  static const Axes table[6] = {{{0, 0, -1}, {0, -1, 0}, {1, 0, 0}}, {{0, 0, 1}, {0, -1, 0}, {-1, 0, 0}},
                                {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},   {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
                                {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}},  {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
  return table[face];
}

Vec SlowShadowMap::in_face(const Axes& axes, Vec p) const {
  const Vec d = p - origin_;
  return {dot(axes.right, d), dot(axes.up, d), dot(axes.ahead, d)};
}

Real SlowShadowMap::depth_of(Real x) const {
  return is_point_ ? far_ / (far_ - near_) * (1 - near_ * x) : (x - near_) / (far_ - near_);
}

DepthDoubt SlowShadowMap::texel(std::size_t face, int column, int row) const {
  const Axes of = axes(face);
  // The ray (x, y, 1) of the texel's centre, and of places beside it.
  std::array<Vec, 4> rays;
  for (int i = 0; i < 4; ++i) {
    const auto place = [&](int texel, bool after) {
      const Real at = (texel + Real(0.5L) + (after ? snap : -snap)) / map_.size * 2 - 1;
      return is_point_ ? at : at * half_;
    };
    rays[static_cast<std::size_t>(i)] = {place(column, i & 1), place(row, i & 2), 1};
  }
  Real farthest_ray = 1;
  for (const Vec ray : rays) farthest_ray = std::max(farthest_ray, size(ray));
  DepthDoubt result;
  for (const auto& triangle : triangles_) {
    if (!finite(triangle[0]) || !finite(triangle[1]) || !finite(triangle[2])) continue;
    std::array<Vec, 3> p;
    std::array<Real, 3> distance, reach;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = in_face(of, triangle[k]);
      distance[k] = p[k].z;
      if (!is_point_) p[k].z = 1;
      reach[k] = std::max(size(triangle[k]) + size(origin_), Real(1));
    }
    // r = sum of weight_k p_k; inside where none is negative, that is where volumes have the determinant's sign.
    const Real determinant = dot(p[0], cross(p[1], p[2]));
    // Seen so nearly from its edge that weights, and depths by them, are not good to what a float holds.
    const bool thin = std::abs(determinant) * stored_doubt / 4 <= rounded * reach[0] * reach[1] * reach[2];
    bool certain = !thin, possible[2] = {thin || determinant < 0, thin || determinant > 0}; // by sign
    std::array<std::array<Real, 4>, 3> volume{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3, last = (k + 2) % 3;
      const Real off = rounded * farthest_ray * reach[next] * reach[last];
      const Vec opposite = cross(p[next], p[last]);
      for (std::size_t i = 0; i < 4; ++i) volume[k][i] = dot(rays[i], opposite);
      const auto [least, greatest] = std::minmax_element(volume[k].begin(), volume[k].end());
      certain = certain && (determinant > 0 ? *least > off : *greatest < -off);
      possible[0] = possible[0] && *least <= off, possible[1] = possible[1] && *greatest >= -off;
    }
    if (!possible[0] && !possible[1]) continue;
    Real lo = infinity, hi = -infinity;
    if (thin) {
      for (const Real z : distance) {
        const Real depth = !is_point_ ? depth_of(z) : z > near_ ? depth_of(1 / z) : 0;
        lo = std::min(lo, depth), hi = std::max(hi, depth);
      }
    } else {
      for (std::size_t i = 0; i < 4; ++i) {
        Real sum = 0, z = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const Real weight = volume[k][i] / determinant;
          sum += weight, z += weight * distance[k];
        }
        const Real depth = depth_of(is_point_ ? sum : z);
        lo = std::min(lo, depth), hi = std::max(hi, depth);
      }
    }
    if (hi < -stored_doubt || lo > 1 + stored_doubt) continue; // beyond a depth plane
    if (lo < stored_doubt || hi > 1 - stored_doubt) certain = false;
    result.lo = std::min(result.lo, std::max(lo - stored_doubt, Real(0)));
    if (certain) result.hi = std::min(result.hi, hi + stored_doubt);
  }
  result.lo = std::min(result.lo, result.hi);
  return result;
}

std::optional<Real> SlowShadowMap::visibility(Vec position, Vec normal) const {
  const Vec d = position - origin_;
  const Real reach = size(position) + size(origin_), off = doubt * reach;
  std::size_t face = 0;
  if (is_point_) {
    const Vec a{std::abs(d.x), std::abs(d.y), std::abs(d.z)};
    const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    const Real longest = component(a, axis);
    for (int other = 0; other < 3; ++other)
      if (other != axis && component(a, other) > longest - 2 * off) return std::nullopt; // on a seam
    face = static_cast<std::size_t>(2 * axis + (component(d, axis) < 0));
  }
  const Axes of = axes(face);
  const Vec at = in_face(of, position);
  const Vec n{dot(of.right, normal), dot(of.up, normal), dot(of.ahead, normal)};
  if (is_point_ && !(at.z > 64 * off)) return std::nullopt;
  const Real width = is_point_ ? 2 * at.z / map_.size : 2 * half_ / map_.size;
  Real bias = real(map_.bias);
  if (map_.slope_bias > 0) {
    const Real run = is_point_ ? std::abs(dot(n, at) / at.z) : std::abs(n.z),
               rise = std::max(std::abs(n.x), std::abs(n.y));
    if (!(run > 0x1p-20L * size(n))) return std::nullopt; // grazed, or without a normal
    bias += real(map_.slope_bias) * rise / run;
  }
  const Real z = at.z - width * bias, z_off = 64 * off + doubt * 0x1p20L * width * bias;
  const auto depth_at = [&](Real distance) {
    return std::min(depth_of(is_point_ ? 1 / std::max(distance, near_) : distance), Real(1));
  };
  const Real lo = depth_at(z - z_off) - doubt, hi = depth_at(z + z_off) + doubt;
  const Real scale = map_.size / (is_point_ ? 2 * at.z : 2 * half_), middle = real(map_.size) / 2;
  const Real u = at.x * scale + middle, v = at.y * scale + middle, place_off = 64 * off * scale + doubt * map_.size;

  const auto lit = [&](int column, int row) -> std::optional<bool> {
    const int last = map_.size - 1;
    if (is_point_) column = std::clamp(column, 0, last), row = std::clamp(row, 0, last);
    if (column < 0 || column > last || row < 0 || row > last) return true;
    const DepthDoubt stored = texel(face, column, row);
    if (hi <= stored.lo) return true;
    if (lo > stored.hi) return false;
    return std::nullopt;
  };
  const bool halves = map_.filter == ShadowFilter::two_by_two;
  const Real from_u = halves ? u - Real(0.5L) : u, from_v = halves ? v - Real(0.5L) : v;
  const Real column = std::floor(from_u), row = std::floor(from_v), fx = from_u - column, fy = from_v - row;
  if (!halves)
    for (const Real f : {fx, fy})
      if (f < place_off || f > 1 - place_off) return std::nullopt;
  if (!(std::abs(column) < 1e6L && std::abs(row) < 1e6L)) return is_point_ ? std::nullopt : std::optional<Real>(1);
  const int first_column = static_cast<int>(column), first_row = static_cast<int>(row);
  if (map_.filter == ShadowFilter::nearest) {
    const std::optional<bool> one = lit(first_column, first_row);
    if (!one) return std::nullopt;
    return *one ? 1 : 0;
  }
  Real sum = 0;
  const int begin = halves ? 0 : -1;
  for (int j = begin; j < 2; ++j)
    for (int i = begin; i < 2; ++i) {
      const std::optional<bool> one = lit(first_column + i, first_row + j);
      if (!one) return std::nullopt;
      if (*one) sum += halves ? (i ? fx : 1 - fx) * (j ? fy : 1 - fy) : 1 / Real(9);
    }
  return sum;
}

} // namespace refraster::slow
