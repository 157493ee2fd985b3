#include "raster/visibility/tile_list.h"

#include <algorithm>
#include <new>
#include <utility>

namespace refraster {

const TileLists::Lists TileLists::no_lists;

void TileLists::reset(std::size_t runs, std::size_t tiles) {
  if (runs_.size() < runs) runs_.resize(runs);
  used_ = runs;
  for (std::size_t i = 0; i < runs; ++i) runs_[i].reset(tiles);
}

std::vector<std::uint32_t> TileLists::sizes(std::size_t tiles) const {
  std::vector<std::uint32_t> sizes(tiles);
  for (std::size_t i = 0; i < used_; ++i)
    for (std::size_t first = 0; first < tiles; first += neighbours) {
      const Lists& lists = *runs_[i].lists_[first / neighbours];
      if (&lists == &no_lists) continue;
      for (std::size_t tile = first; tile < std::min(first + neighbours, tiles); ++tile) {
        const List& list = lists[tile - first];
        for (Chunk* chunk = list.first; chunk; chunk = chunk->next)
          sizes[tile] +=
              chunk == list.last ? static_cast<std::uint32_t>(list.next - chunk->entries()) : chunk->capacity;
      }
    }
  return sizes;
}

std::size_t TileLists::bytes() const {
  std::size_t all = 0;
  for (std::size_t i = 0; i < used_; ++i) all += runs_[i].bytes();
  return all;
}

void TileLists::Run::reset(std::size_t tiles) {
  // Nothing is written to these: grow() puts others in their place first.
  lists_.assign((tiles + neighbours - 1) / neighbours, const_cast<Lists*>(&no_lists));
  used_rooms_ = block_ = used_ = 0;
}

TileEntry* TileLists::Run::allocate(std::size_t entries) {
  if (block_ < blocks_.size() && used_ + entries > block_entries(block_)) ++block_, used_ = 0;
  if (block_ == blocks_.size()) blocks_.push_back(std::make_unique_for_overwrite<TileEntry[]>(block_entries(block_)));
  return &blocks_[block_][std::exchange(used_, used_ + entries)];
}

TileLists::List& TileLists::Run::grow(std::size_t tile) {
  Lists*& lists = lists_[tile / neighbours];
  if (lists == &no_lists) {
    if (used_rooms_ == rooms_.size()) rooms_.push_back(std::make_unique<Lists>());
    lists = rooms_[used_rooms_++].get();
    *lists = {};
  }
  List& list = (*lists)[tile % neighbours];
  constexpr std::uint32_t min_size = 8, max_size = 256; // with the chunk's own head
  const std::uint32_t size = list.last ? std::min(2 * (list.last->capacity + 1), max_size) : min_size;
  auto* const chunk = new (allocate(size)) Chunk{nullptr, size - 1};
  (list.last ? list.last->next : list.first) = chunk;
  list.last = chunk;
  list.next = chunk->entries(), list.end = list.next + chunk->capacity;
  return list;
}

std::size_t TileLists::Run::bytes() const {
  std::size_t entries = used_;
  for (std::size_t block = 0; block < block_; ++block) entries += block_entries(block);
  return lists_.size() * sizeof(Lists*) + used_rooms_ * sizeof(Lists) + entries * sizeof(TileEntry);
}

} // namespace refraster
