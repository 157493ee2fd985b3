#include "raster/visibility/depth_tile.h"

#include "raster/visibility/depth_range.h"

#include <algorithm>

namespace refraster {

namespace {

using Row = DepthTile::Row;

MaskOf<Row> first_pixels(int count) {
  return lane_numbers<double, DepthTile::lanes>() < Row(static_cast<double>(count));
}

template <int N>
double max_lane(const Wide<double, N>& x) {
  if constexpr (N == 2) return max(x[0], x[1]);
  else return max_lane(max(low_half(x), high_half(x)));
}

} // namespace

DepthTile::DepthTile(int tile_size)
    : rows_(static_cast<std::size_t>(tile_size)), stride_(static_cast<std::size_t>(tile_size + lanes)),
      column_bound_((rows_ + block - 1) / block * stride_), block_bound_(column_bound_.size() / block) {}

void DepthTile::clear(const PixelRect& tile, std::size_t samples) {
  width_ = tile.width, height_ = tile.height, samples_ = samples;
  tile_bound_ = unbounded;
  depth_.assign(samples * rows_ * stride_, beyond_far);
  nearest_.assign(samples * rows_ * stride_, nothing);
}

void DepthTile::refresh_bounds() {
  tile_bound_ = -1; // no depth is less
  for (int row = 0; row * block < height_; ++row) {
    const int top = row * block, bottom = std::min(top + block, height_);
    for (int column = 0; column * block < width_; ++column) {
      Row deepest(-1.0);
      for (int x = column * block; x < std::min((column + 1) * block, width_); x += lanes) {
        Row in_columns(-1.0);
        for (std::size_t s = 0; s < samples_; ++s)
          for (int y = top; y < bottom; ++y)
            in_columns = max(in_columns, load_lanes<Row>(&depth_[at(static_cast<int>(s), x, y)]));
        in_columns = select(first_pixels(width_ - x), in_columns, Row(-1.0));
        store_lanes(&column_bound_[column_at(row, x)], in_columns);
        deepest = max(deepest, in_columns);
      }
      block_bound_[block_at(row, column)] = max_lane(deepest);
      tile_bound_ = max(tile_bound_, block_bound_[block_at(row, column)]);
    }
  }
}

bool DepthTile::are_blocks_occluded(int left, int top, int right, int bottom, double z) const {
  for (int row = top / block; row <= bottom / block; ++row)
    for (int column = left / block; column <= right / block; ++column) {
      if (!(block_bound_[block_at(row, column)] >= z)) continue;
      const int end = std::min(right + 1, (column + 1) * block);
      for (int x = std::max(left, column * block); x < end; x += lanes)
        if (any(first_pixels(end - x) & (load_lanes<Row>(&column_bound_[column_at(row, x)]) >= Row(z)))) return false;
    }
  return true;
}

} // namespace refraster
