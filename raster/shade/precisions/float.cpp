#include "raster/shade/shade_tile.h"

namespace refraster {

std::unique_ptr<TileShading> make_float_shading() {
  return std::make_unique<TileShadingOf<FloatPrecision::Number>>();
}

} // namespace refraster
