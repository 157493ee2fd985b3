#include "raster/shade/shade_tile.h"

namespace refraster {

std::unique_ptr<TileShader> make_fast_shader() {
  return std::make_unique<TileShaderOf<FastRung::Number>>();
}

} // namespace refraster
