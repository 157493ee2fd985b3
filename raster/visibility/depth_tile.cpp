#include "raster/visibility/depth_tile.h"

#include "raster/visibility/depth_range.h"

#include <algorithm>

namespace refraster {

DepthTile::DepthTile(int tile_size)
    : rows_(static_cast<std::size_t>(tile_size)), stride_(static_cast<std::size_t>(tile_size + lanes)),
      bound_((rows_ + block - 1) / block * stride_) {}

void DepthTile::clear(const PixelRect& tile, std::size_t samples) {
  height_ = tile.height, samples_ = samples;
  bounded_ = false;
  depth_.assign(samples * rows_ * stride_, beyond_far);
  nearest_.assign(samples * rows_ * stride_, nothing);
}

void DepthTile::refresh_bounds() {
  bounded_ = true;
  for (int top = 0; top < height_; top += block)
    for (std::size_t x = 0; x < stride_; x += lanes) {
      Row deepest(-1.0);
      for (std::size_t s = 0; s < samples_; ++s)
        for (int y = top; y < std::min(top + block, height_); ++y)
          deepest = max(deepest, load_lanes<Row>(&depth_[at(static_cast<int>(s), 0, y) + x]));
      store_lanes(&bound_[static_cast<std::size_t>(top / block) * stride_ + x], deepest);
    }
}

} // namespace refraster
