#pragma once
// Normals that textures turn: docs/normal-maps.md.

#include <refraster/material.h>

#include "shading/texture.h"

namespace refraster::inline REFRASTER_KIT {

/// The sign of each scale of texture coordinates: where one is negative the image is seen from behind along that axis,
/// and what rises to its right falls with u. With 0 the image does not change that way.
inline Double2 direction_signs(const TextureMap& map) {
  const auto sign = [](double x) { return static_cast<double>((x > 0) - (x < 0)); };
  return {sign(map.scale.x), sign(map.scale.y)};
}

// What GLSL is given as uniforms, too.

/// What red and green of a normal map, as coordinates, are multiplied by.
inline Double2 normal_factors(const Material& material) {
  return direction_signs(material.normal_map) * material.normal_scale;
}
/// What differences of heights two texels apart are multiplied by, to be slopes.
inline Double2 slope_factors(const Material& material) {
  return direction_signs(material.bump_map) * (0.5 * material.bump_scale);
}
/// The width and height of a texel of a bump map, in texture coordinates of the image.
inline Double2 texel_size(const TextureMap& map) {
  const TextureLevel& image = map.texture->levels[0];
  return {1.0 / image.width, 1.0 / image.height};
}

/// The colour of a normal map as a direction: 2 colour - 1, x and y times their factors.
template <Number T>
Vec3<T> map_normal(const Material& material, const Rgb<T>& colour) {
  const Double2 factors = normal_factors(material);
  const Vec3<T> direction = colour * T(2) - Vec3<T>(T(1));
  return {direction.x * as<T>(within_range<T>(factors.x)), direction.y * as<T>(within_range<T>(factors.y)),
          direction.z};
}

/// What the heights of a texture, red, differ by two texels apart: from the left to the right of a point, and from
/// below to above it. The third component is 0.
struct ReadSlopes {
  template <class T>
  [[gnu::noinline]] Rgb<T> operator()(const TextureMap& map, const Vec2<T>& uv, const Vec2<T>& right,
                                      const Vec2<T>& down) const {
    const PlacedTexture<T> here = placed(map, uv, right, down);
    const Double2 texel = texel_size(map);
    const auto rise = [&](int axis) {
      const T step = as<T>(texel[axis]);
      PlacedTexture<T> before = here, after = here;
      before.at[axis] = here.at[axis] - step, after.at[axis] = here.at[axis] + step;
      return sample(map, after).x - sample(map, before).x;
    };
    return {rise(0), rise(1), T(0)};
  }
};

/// n, unit, as the direction m in the frame of tangent, bitangent and normal has it:
///
///     unit(m.x t + m.y b + m.z n),     b = w cross(n, t),
///
/// t and w the tangent's direction and handedness as they are interpolated. Where the sum is 0 or beyond all numbers,
/// and where n is 0, n itself: `usable` says where not.
template <Number T>
Vec3<T> turned_normal(const Vec3<T>& n, const Vec4<T>& tangent, const Vec3<T>& m, MaskOf<T>& usable) {
  const Vec3<T> t(tangent.x, tangent.y, tangent.z);
  const Vec3<T> b = cross(n, t) * tangent.w;
  const Vec3<T> sum = t * m.x + b * m.y + n * m.z;
  const T size = abs(sum.x) + abs(sum.y) + abs(sum.z);
  usable = (size > T(0)) & (size <= largest_number<T>()) & (squared_length(n) > T(0));
  return select<T>(usable, normalize(sum), n);
}

} // namespace refraster::inline REFRASTER_KIT
