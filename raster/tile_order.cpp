#include "raster/tile_order.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace refraster {

std::vector<std::uint32_t> tile_order(const TileGrid& grid, const TileLists& lists, int threads) {
  std::vector<std::uint32_t> order(grid.tiles());
  std::iota(order.begin(), order.end(), 0u);
  if (threads == 1) return order;
  // Where there is anything, most pixels may be covered, and one takes about as long as an entry does. What differs by
  // less than twice is as good as alike, and stays in place.
  std::vector<std::uint8_t> work(order.size());
  const std::vector<std::uint32_t> sizes = lists.sizes(order.size());
  for (const std::uint32_t tile : order)
    if (const std::size_t entries = sizes[tile]) {
      const PixelRect pixels = grid.tile(tile);
      work[tile] = static_cast<std::uint8_t>(
          std::bit_width(entries + static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height)));
    }
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return work[a] > work[b]; });
  return order;
}

} // namespace refraster
