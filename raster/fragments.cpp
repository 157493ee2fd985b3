#include "raster/shade.h"

namespace refraster {

void list_fragments(const TileVisibility& visibility, const Crop& tile, int samples,
                    std::vector<TileFragment>& fragments) {
  fragments.clear();
  for (int y = 0; y < tile.height; ++y)
    for (int x = 0; x < tile.width; ++x) {
      const std::size_t first = fragments.size();
      for (int s = 0; s < samples; ++s) {
        const std::int32_t place = visibility.nearest(s, x, y);
        if (place == nothing) continue;
        std::size_t i = first;
        while (i < fragments.size() && fragments[i].place != place) ++i;
        if (i < fragments.size()) ++fragments[i].samples;
        else fragments.push_back({place, static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 1});
      }
    }
}

std::unique_ptr<TileShader> make_tile_shader(std::string_view rung) {
  if (rung == "double") return make_double_shader();
  if (rung == "float") return make_float_shader();
  return nullptr;
}

} // namespace refraster
