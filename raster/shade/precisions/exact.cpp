#include "raster/shade/sample_data.h"
#include "raster/shade/shade_tile.h"

namespace refraster {

template class TileShadingOf<Exact>;

std::unique_ptr<TileShading> make_exact_shading() {
  return std::make_unique<TileShadingOf<ExactPrecision::Number>>();
}

} // namespace refraster
