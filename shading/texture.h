#pragma once
// How textures are sampled.

#include <refraster/texture.h>

#include "math/bounds/texture_errors.h"
#include "math/elementary.h"
#include "math/read_grid.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace refraster::inline REFRASTER_KIT {

/// To be read at (x, y, 0).
template <class F>
RgbGrid<F, float> texels_of(const TextureLevel& level) {
  return {level.rgb.data(), 3, 3 * level.width, 0};
}
/// How it goes on along both axes.
template <TextureWrap wrap>
std::array<GridAxis, 2> axes_of(const TextureLevel& level) {
  constexpr auto beyond = wrap == TextureWrap::repeat ? GridAxis::Beyond::repeated : GridAxis::Beyond::clamped;
  return {GridAxis{beyond, level.width}, GridAxis{beyond, level.height}};
}
/// The texel of a row or column of n that stands at i.
template <TextureWrap wrap, class Index>
Index texel_index(const Index& i, std::int32_t n) {
  if constexpr (wrap == TextureWrap::repeat) return wrap_index(i, n);
  else return clamp_index(i, 0, n - 1);
}

/// u without those whole turns that only cost precision, exactly. Table indices hold 2^30 cells, and a level has up to
/// 2^16 a turn: so that u may have 2^14 turns. For |u| >= 2^44 the result is 0.
template <Number T>
T fewer_turns(const T& u) {
  constexpr double turns = 1 << 14;
  return select(abs(u) < as<T>(turns), u, as<T>(turns) * fraction(u * as<T>(1 / turns)));
}

/// u where it means the same and costs no precision.
template <TextureWrap wrap, Number T>
T near_image(const T& u) {
  if constexpr (wrap == TextureWrap::repeat) return fewer_turns(u);
  else return min(max0(u), T(1)); // beyond, the texels of the edge go on
}

/// x, which a device may have lower by `below` and higher by `above`: for bounds; other numbers are exact about it. The
/// errors are times `scale`.
template <Number T>
T as_read([[maybe_unused]] const T& x, [[maybe_unused]] double TextureErrors::*below,
          [[maybe_unused]] double TextureErrors::*above, [[maybe_unused]] double scale = 1) {
  if constexpr (requires { NumberTraits<T>::texture_errors(); }) {
    const TextureErrors& errors = NumberTraits<T>::texture_errors();
    if (errors.*below != 0 || errors.*above != 0) return x + T(-(errors.*below) * scale, errors.*above * scale);
  }
  return x;
}
template <Number T>
Rgb<T> as_read(const Rgb<T>& rgb, double TextureErrors::*error, double scale = 1) {
  return {as_read(rgb.x, error, error, scale), as_read(rgb.y, error, error, scale),
          as_read(rgb.z, error, error, scale)};
}

/// The texel that holds the point, as stored.
template <TextureWrap wrap = TextureWrap::repeat, Number T>
Rgb<T> sample_nearest(const TextureLevel& level, const Vec2<T>& uv) {
  const auto texels = texels_of<RealOf<T>>(level);
  const auto placed = [](const T& x) { return as_read(x, &TextureErrors::nearest, &TextureErrors::nearest); };
  const std::array<T, 2> place = {placed(uv.x * as<T>(level.width)), placed(uv.y * as<T>(level.height))};
  return read_nearest(place, axes_of<wrap>(level), [&](const std::array<Cell<T>, 2>& cell) {
    return stored_value<T>(texels, texel_index<wrap>(cell[0].index, level.width),
                           texel_index<wrap>(cell[1].index, level.height), IndexOf<T>{});
  });
}

/// Between the four texels around the point, as stored: texel k has its centre at (k + 0.5) / n.
template <TextureWrap wrap = TextureWrap::repeat, Number T>
Rgb<T> sample_bilinear(const TextureLevel& level, const Vec2<T>& uv) {
  const auto texels = texels_of<RealOf<T>>(level);
  const auto placed = [](const T& x) { return as_read(x - as<T>(0.5), &TextureErrors::place, &TextureErrors::place); };
  const std::array<T, 2> place = {placed(uv.x * as<T>(level.width)), placed(uv.y * as<T>(level.height))};
  return read_grid(place, axes_of<wrap>(level), [&](const std::array<Cell<T>, 2>& cell) {
    const auto& [x, y] = cell;
    // Wrapping follows the floor, in integers: a point just left of u = 0 lies between the last texel and the first.
    const IndexOf<T> left = texel_index<wrap>(x.index, level.width),
                     right = texel_index<wrap>(next_index(x.index), level.width);
    const IndexOf<T> low = texel_index<wrap>(y.index, level.height),
                     high = texel_index<wrap>(next_index(y.index), level.height);
    const auto row = [&](const IndexOf<T>& j, const T& along) {
      return mix(stored_value<T>(texels, left, j, IndexOf<T>{}), stored_value<T>(texels, right, j, IndexOf<T>{}),
                 along);
    };
    return mix(row(low, x.fraction), row(high, x.fraction), y.fraction);
  });
}

/// The level of detail: log2 of the longer side of a pixel's footprint, in texels of level 0. OpenGL 4.6,
/// section 8.14.1.
template <Number T>
T level_of_detail(const TextureLevel& image, const Vec2<T>& uv_dx, const Vec2<T>& uv_dy) {
  const auto texels = [&](const Vec2<T>& uv_step) {
    return length(Vec3<T>(uv_step.x * as<T>(image.width), uv_step.y * as<T>(image.height), T(0)));
  };
  return as_read(log2(max(texels(uv_dx), texels(uv_dy))), &TextureErrors::detail_below, &TextureErrors::detail_above);
}

/// A level of the chain, filtered; as a device has stored it.
template <TextureWrap wrap, Number T>
Rgb<T> sample_level(const Texture& texture, std::size_t k, const Vec2<T>& uv) {
  const Rgb<T> colour = sample_bilinear<wrap>(texture.levels[k], uv);
  return k == 0 ? colour : as_read(colour, &TextureErrors::mip, texture.full_scale);
}

/// Between the two levels on either side of the level of detail; the image itself where it is magnified.
template <TextureWrap wrap = TextureWrap::repeat, Number T>
Rgb<T> sample_trilinear(const Texture& texture, const Vec2<T>& uv, const Vec2<T>& uv_dx, const Vec2<T>& uv_dy) {
  const T last = as<T>(static_cast<double>(texture.levels.size() - 1));
  const T detail = min(max0(level_of_detail(texture.levels[0], uv_dx, uv_dy)), last);
  if constexpr (!NumberTraits<T>::decides) { // of bounds, the shares of two levels depend on each other
    const auto count = static_cast<std::int32_t>(texture.levels.size());
    return read_grid(std::array{detail}, std::array{GridAxis{GridAxis::Beyond::clamped, count}},
                     [&](const std::array<Cell<T>, 1>& cell) {
                       const auto level = [&](std::int32_t k) {
                         return sample_level<wrap>(texture, static_cast<std::size_t>(clamp_index(k, 0, count - 1)), uv);
                       };
                       return mix(level(cell[0].index), level(cell[0].index + 1), cell[0].fraction);
                     });
  }
  Rgb<T> sum(T(0));
  for (std::size_t k = 0; k < texture.levels.size(); ++k) {
    // 1 at its own level, falling to 0 at the next ones: two levels at most have a share, and the shares add up to 1.
    const T weight = max0(T(1) - abs(detail - as<T>(static_cast<double>(k))));
    if (any(weight > T(0))) sum += sample_level<wrap>(texture, k, uv) * weight;
  }
  return sum;
}

/// The texture's colour at uv, repeated or clamped in all directions, v upward; linear values as stored, divided by
/// full_scale at the very end. uv_dx and uv_dy are the derivatives of uv by one pixel to the right and down; only
/// trilinear reads them. A component of uv that is NaN or infinite is taken as 0 (clamped, an infinity is an edge); the
/// caller counts it (Undefined::bad_uv).
template <TextureWrap wrap = TextureWrap::repeat, Number T>
Rgb<T> sample(const Texture& texture, TextureFilter filter, const Vec2<T>& uv, const Vec2<T>& uv_dx,
              const Vec2<T>& uv_dy) {
  const Vec2<T> near(near_image<wrap>(uv.x), near_image<wrap>(uv.y));
  const auto stored = [&] {
    switch (filter) {
    case TextureFilter::nearest:
      return sample_nearest<wrap>(texture.levels[0], near);
    case TextureFilter::bilinear:
      return sample_bilinear<wrap>(texture.levels[0], near);
    case TextureFilter::trilinear:
      return sample_trilinear<wrap>(texture, near, uv_dx, uv_dy);
    }
    return Rgb<T>(T(0));
  };
  const Rgb<T> colour = stored() / as<T>(texture.full_scale);
  return filter == TextureFilter::nearest ? colour : as_read(colour, &TextureErrors::filter);
}

/// What u * scale + offset changes by where u changes by `step`. A device takes the difference of two of them, of which
/// the product and the sum are rounded each.
template <Number T>
T placed_step(const T& step, [[maybe_unused]] const T& u, double scale, [[maybe_unused]] double offset) {
  const T placed = step * as<T>(scale);
  if constexpr (requires { NumberTraits<T>::device_rounding(); }) {
    const T product = (abs(u) + abs(step)) * as<T>(std::abs(scale)), sum = product + as<T>(std::abs(offset));
    const double error = 2 * (1 + 0x1p-20) * NumberTraits<T>::device_rounding() * (product.hi + sum.hi);
    return placed + T(-error, error);
  }
  return placed;
}

/// Where an image is read, and what that changes by for a pixel to the right and down.
template <class T>
struct PlacedTexture {
  Vec2<T> at, right, down;
};

/// The place in the image of the texture coordinates uv, which change as in sample() of a texture.
template <Number T>
PlacedTexture<T> placed(const TextureMap& map, const Vec2<T>& uv, const Vec2<T>& uv_dx, const Vec2<T>& uv_dy) {
  if (!map.is_placed()) return {uv, uv_dx, uv_dy};
  const Double2 &scale = map.scale, &offset = map.offset;
  const Vec2<T> at(uv.x * as<T>(scale.x) + as<T>(offset.x), uv.y * as<T>(scale.y) + as<T>(offset.y));
  const auto step = [&](const Vec2<T>& by) {
    return Vec2<T>(placed_step(by.x, uv.x, scale.x, offset.x), placed_step(by.y, uv.y, scale.y, offset.y));
  };
  return {at, step(uv_dx), step(uv_dy)};
}

/// The colour there. The texture is there.
template <Number T>
Rgb<T> sample(const TextureMap& map, const PlacedTexture<T>& place) {
  if (map.wrap == TextureWrap::repeat) return sample(*map.texture, map.filter, place.at, place.right, place.down);
  return sample<TextureWrap::clamp>(*map.texture, map.filter, place.at, place.right, place.down);
}

/// The colour of a material's texture at the texture coordinates uv: every number reads every slot by this.
template <Number T>
Rgb<T> sample(const TextureMap& map, const Vec2<T>& uv, const Vec2<T>& uv_dx, const Vec2<T>& uv_dy) {
  return sample(map, placed(map, uv, uv_dx, uv_dy));
}

} // namespace refraster::inline REFRASTER_KIT
