#include "raster/shade/sample_data.h"
#include "raster/shade/shade_tile.h"

namespace refraster {

template class TileShaderOf<Exact>;

std::unique_ptr<TileShader> make_exact_shader() {
  return std::make_unique<TileShaderOf<ExactRung::Number>>();
}

} // namespace refraster
