#include "raster/visibility/tile_list.h"

#include <algorithm>
#include <new>
#include <utility>

namespace refraster {

void TileLists::reset(std::size_t runs, std::size_t tiles) {
  if (runs_.size() < runs) runs_.resize(runs);
  used_ = runs;
  for (std::size_t i = 0; i < runs; ++i) runs_[i].reset(tiles);
}

void TileLists::Run::reset(std::size_t tiles) {
  lists_.assign(tiles, {});
  block_ = used_ = 0;
}

TileEntry* TileLists::Run::allocate(std::size_t entries) {
  if (block_ < blocks_.size() && used_ + entries > block_entries) ++block_, used_ = 0;
  if (block_ == blocks_.size()) blocks_.push_back(std::make_unique_for_overwrite<TileEntry[]>(block_entries));
  return &blocks_[block_][std::exchange(used_, used_ + entries)];
}

void TileLists::Run::grow(List& list) {
  constexpr std::uint32_t min_size = 8, max_size = 256; // with the chunk's own head
  const std::uint32_t size = list.last ? std::min(2 * (list.last->capacity + 1), max_size) : min_size;
  auto* const chunk = new (allocate(size)) Chunk{nullptr, size - 1};
  (list.last ? list.last->next : list.first) = chunk;
  list.last = chunk;
  list.next = chunk->entries(), list.end = list.next + chunk->capacity;
}

} // namespace refraster
