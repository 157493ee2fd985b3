#include "raster/shade/shade_tile.h"

namespace refraster {

std::unique_ptr<TileShading> make_fast_shading() {
  return std::make_unique<TileShadingOf<FastPrecision::Number>>();
}

} // namespace refraster
