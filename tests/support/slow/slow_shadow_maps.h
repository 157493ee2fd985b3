#pragma once
// Depth maps of lights in long double, texel by texel, from docs/shadow-maps.md: for each texel every triangle is met
// with the texel's own ray. No rasterizer, no matrices.

#include "tests/support/slow/slow_visibility.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace refraster::slow {

/// What a map may hold: window depth.
struct DepthDoubt {
  Real lo = 1, hi = 1;
};

/// A texel that is compared.
struct MapTexel {
  std::size_t face = 0;
  int column = 0, row = 0; // from the lower left corner; outside where it is lit
  Real weight = 1;
};

/// The map of one light.
class SlowShadowMap {
public:
  SlowShadowMap(const Scene& scene, const PointLight& light);
  SlowShadowMap(const Scene& scene, const DirectionLight& light);

  /// What a texel may hold: corners of triangles are snapped to 1/256 texel before it is filled, so that the ray may be
  /// off by as much, and by it what it meets.
  DepthDoubt texel(std::size_t face, int column, int row) const;

  /// How much of the light a surface sees; nothing where rounding decides.
  std::optional<Real> visibility(Vec position, Vec normal) const;

  Real near() const { return near_; }
  Real far() const { return far_; }

private:
  struct Axes {
    Vec right, up, ahead;
  };
  void start(const Scene& scene, const ShadowMap& map);
  Axes axes(std::size_t face) const;
  Vec in_face(const Axes& axes, Vec p) const;
  /// Window depth of what lies at 1 / w, a distance's reciprocal, or at a distance.
  Real depth_of(Real inverse_or_distance) const;

  bool is_point_ = false;
  ShadowMap map_;
  Vec low_{}, high_{};
  Vec origin_;
  Axes axes_{};
  Real half_ = 1, near_ = 0, far_ = 1;
  std::vector<std::array<Vec, 3>> triangles_; // in the world
};

} // namespace refraster::slow
