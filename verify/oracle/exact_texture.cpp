#include "verify/oracle/exact_texture.h"

#include <algorithm>

namespace refraster::oracle {
namespace {

std::size_t wrapped(long i, int n) {
  return static_cast<std::size_t>((i % n + n) % n);
}

Exact3 texel(const TextureLevel& level, long x, long y) {
  const auto width = static_cast<std::size_t>(level.width);
  const std::size_t at = 3 * (wrapped(y, level.height) * width + wrapped(x, level.width));
  return {Exact(level.rgb[at]), Exact(level.rgb[at + 1]), Exact(level.rgb[at + 2])};
}

Exact3 bilinear(const TextureLevel& level, const Exact& u, const Exact& v) {
  const Exact x = u * level.width - 0.5, y = v * level.height - 0.5;
  const long i = whole(x), j = whole(y);
  const Exact s = x - i, t = y - j;
  return texel(level, i, j) * ((1 - s) * (1 - t)) + texel(level, i + 1, j) * (s * (1 - t)) +
         texel(level, i, j + 1) * ((1 - s) * t) + texel(level, i + 1, j + 1) * (s * t);
}

Exact3 trilinear(const Texture& texture, const SurfacePoint& at) {
  const TextureLevel& image = texture.levels[0];
  const auto texels = [&](const Exact& du, const Exact& dv) {
    return sqrt(du * du * image.width * image.width + dv * dv * image.height * image.height);
  };
  const Exact longer = std::max(texels(at.u_right, at.v_right), texels(at.u_down, at.v_down));
  const std::size_t last = texture.levels.size() - 1;
  const Exact detail = longer > 1 ? std::min(log2(longer), Exact(last)) : Exact(0);
  const auto lower = static_cast<std::size_t>(whole(detail)), upper = std::min(lower + 1, last);
  const Exact share = detail - lower;
  return bilinear(texture.levels[lower], at.u, at.v) * (1 - share) +
         bilinear(texture.levels[upper], at.u, at.v) * share;
}

} // namespace

Exact3 texture_colour(const Material& material, const SurfacePoint& at) {
  if (!material.texture || !at.has_uv) return {1, 1, 1};
  const Texture& texture = *material.texture;
  const TextureLevel& image = texture.levels[0];
  const Exact scale = 1 / Exact(texture.full_scale);
  switch (material.texture_filter) {
  case TextureFilter::nearest:
    return texel(image, whole(at.u * image.width), whole(at.v * image.height)) * scale;
  case TextureFilter::bilinear:
    return bilinear(image, at.u, at.v) * scale;
  case TextureFilter::trilinear:
    return trilinear(texture, at) * scale;
  }
  return {0, 0, 0};
}

} // namespace refraster::oracle
