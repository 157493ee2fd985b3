#include "raster/shade/shade_tile.h"

namespace refraster {

std::unique_ptr<TileShader> make_float_shader() {
  return std::make_unique<TileShaderOf<FloatRung::Number>>();
}

} // namespace refraster
