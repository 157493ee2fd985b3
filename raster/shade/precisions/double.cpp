#include "raster/shade/shade_tile.h"

namespace refraster {

std::unique_ptr<TileShader> make_double_shader() {
  return std::make_unique<TileShaderOf<DoubleRung::Number>>();
}

} // namespace refraster
