#include "shading/texture.h"

#include "shading/srgb_curve.h"

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

namespace refraster {

namespace {

/// The texels of a row of `length` that cell k of `cells` equal cells covers, from the first to the last, and the share
/// of the cell that lies in each of them.
struct Cover {
  int first = 0, count = 0;
  double weight[3] = {};
};

Cover cover(int length, int cells, int k) {
  // In units of 1 / cells of a texel, everything is a whole number: cell k is [k length, (k + 1) length).
  const std::int64_t begin = std::int64_t{k} * length, end = begin + length;
  Cover result;
  result.first = static_cast<int>(begin / cells);
  for (std::int64_t texel = result.first; texel * cells < end; ++texel) {
    const std::int64_t inside = std::min(end, (texel + 1) * cells) - std::max(begin, texel * cells);
    result.weight[result.count++] = static_cast<double>(inside) / static_cast<double>(length);
  }
  return result;
}

TextureLevel halved(const TextureLevel& below) {
  TextureLevel level{std::max(1, below.width / 2), std::max(1, below.height / 2), {}};
  const auto texels = texels_of<double>(below);
  level.rgb.reserve(3 * static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height));
  for (int y = 0; y < level.height; ++y) {
    const Cover rows = cover(below.height, level.height, y);
    for (int x = 0; x < level.width; ++x) {
      const Cover columns = cover(below.width, level.width, x);
      Rgb<double> mean(0);
      for (int j = 0; j < rows.count; ++j)
        for (int i = 0; i < columns.count; ++i)
          mean += texels(columns.first + i, rows.first + j, 0) * (rows.weight[j] * columns.weight[i]);
      for (const double channel : {mean.x, mean.y, mean.z}) level.rgb.push_back(static_cast<float>(channel));
    }
  }
  return level;
}

bool is_whole(const TextureLevel& level) {
  return level.width >= 1 && level.height >= 1 &&
         level.rgb.size() == 3 * static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height);
}

} // namespace

void build_mip_levels(Texture& texture) {
  if (texture.levels.size() != 1 || !is_whole(texture.levels[0]))
    throw std::invalid_argument("build_mip_levels: expected a texture of one level, with all its texels");
  while (texture.levels.back().width > 1 || texture.levels.back().height > 1)
    texture.levels.push_back(halved(texture.levels.back()));
}

void decode_srgb(Texture& texture) {
  if (texture.levels.size() != 1 || !is_whole(texture.levels[0]))
    throw std::invalid_argument("decode_srgb: expected a texture of one level, with all its texels");
  // A file has few different values: each is decoded once.
  std::unordered_map<float, float> decoded;
  for (float& value : texture.levels[0].rgb) {
    const auto [entry, is_new] = decoded.try_emplace(value);
    if (is_new) entry->second = static_cast<float>(srgb_decoded(static_cast<double>(value) / texture.full_scale));
    value = entry->second;
  }
  texture.full_scale = 1;
}

} // namespace refraster
