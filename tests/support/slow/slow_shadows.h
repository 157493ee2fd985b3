#pragma once
// What lies between a surface and a light, triangle by triangle in long double: no tree, no exact signs.

#include "tests/support/slow/slow_visibility.h"

#include <array>
#include <optional>
#include <vector>

namespace refraster::slow {

/// All triangles of a scene in the world.
class ShadowCasters {
public:
  explicit ShadowCasters(const Scene& scene);

  /// Whether the light at `to`, or in that direction, is seen from what is seen. Nothing where rounding decides: the
  /// way passes the edge of a triangle, or begins or ends in its plane, but for the surface's own.
  std::optional<bool> sees(const Seen& seen, Vec to, bool is_direction) const;

private:
  struct Caster {
    const Object* object;
    std::uint32_t triangle;
    std::array<Vec, 3> corner;
  };
  std::vector<Caster> casters_;
};

} // namespace refraster::slow
