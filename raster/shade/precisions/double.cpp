#include "raster/shade/shade_tile.h"

namespace refraster {

std::unique_ptr<TileShading> make_double_shading() {
  return std::make_unique<TileShadingOf<DoublePrecision::Number>>();
}

} // namespace refraster
