#pragma once
// What binning hands to the tiles: for each tile a list in submission order, written by several threads without locks.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

namespace refraster {

/// Something a tile has to look at. Pixels are counted from the tile's corner.
struct TileEntry {
  /// sample: one that a small triangle covers, at a depth that is drawn; its place is bytes(x, y, sample_mark, s).
  enum class Kind { box, projective, sample };

  std::uint32_t triangle; // number in the frame; entries of one triangle follow one another
  std::uint32_t place;    // four bytes, see below
  double z;               // sample: depth there; box: the least of the corners' depths

  /// A triangle on the lattice that may cover samples of these pixels, ends included.
  static TileEntry box(std::uint32_t triangle, int left, int top, int right, int bottom, double z_min) {
    return {triangle, bytes(left, top, right, bottom), z_min};
  }
  /// A triangle that needs projective set-up.
  static TileEntry projective(std::uint32_t triangle) { return {triangle, bytes(0, 0, projective_mark, 0), 0}; }

  Kind kind() const {
    return right() == sample_mark ? Kind::sample : right() == projective_mark ? Kind::projective : Kind::box;
  }
  int left() const { return static_cast<int>(place & 255); }
  int top() const { return static_cast<int>(place >> 8 & 255); }
  int right() const { return static_cast<int>(place >> 16 & 255); }
  int bottom() const { return static_cast<int>(place >> 24); }
  int x() const { return left(); }
  int y() const { return top(); }
  int s() const { return bottom(); }

  // Stand where a box has its right end: a tile has at most 128 pixels a side.
  static constexpr int sample_mark = 255, projective_mark = 254;
  static constexpr std::uint32_t bytes(int a, int b, int c, int d) {
    return static_cast<std::uint32_t>(a | b << 8 | c << 16) | static_cast<std::uint32_t>(d) << 24;
  }
};
static_assert(sizeof(TileEntry) == 16 && std::is_trivial_v<TileEntry>);

/// One list for each tile, in pieces that come from runs of consecutive triangles: a run is written by one thread, and
/// a tile's list is what the runs wrote for it, in their order. A run has room for the lists of neighbouring tiles once
/// it lists anything there: most runs see a small part of a large image. Chunks of memory grow with a list, up to 4
/// KiB, and are kept from frame to frame.
class TileLists {
public:
  class Run;

  /// Empty lists. What they held is lost.
  void reset(std::size_t runs, std::size_t tiles);
  Run& run(std::size_t i);

  /// Calls body(span of entries) for the pieces of a tile's list.
  template <class Body>
  void for_each_piece(std::size_t tile, Body&& body) const;

  /// How many entries each tile's list has. Neighbouring tiles of which a run lists none take no time but that of
  /// seeing it.
  std::vector<std::uint32_t> sizes(std::size_t tiles) const;
  /// What was taken for the lists since reset(): their heads, and chunks. Written once, or for the most part.
  std::size_t bytes() const;

private:
  struct Chunk {
    Chunk* next = nullptr;
    std::uint32_t capacity = 0;
    TileEntry* entries() { return reinterpret_cast<TileEntry*>(this + 1); }
  };
  static_assert(sizeof(Chunk) == sizeof(TileEntry));
  struct List {
    TileEntry *next = nullptr, *end = nullptr; // of the last chunk
    Chunk *first = nullptr, *last = nullptr;
  };
  static constexpr std::size_t neighbours = 32; // tiles whose lists have room together
  using Lists = std::array<List, neighbours>;
  static const Lists no_lists; // of tiles where nothing is listed

  std::vector<Run> runs_;
  std::size_t used_ = 0; // runs
};

/// For one thread at a time.
class TileLists::Run {
public:
  void add(std::size_t tile, const TileEntry& entry) {
    List* list = &list_of(tile);
    if (list->next == list->end) [[unlikely]]
      list = &grow(tile);
    *list->next++ = entry;
  }

private:
  friend class TileLists;
  List& list_of(std::size_t tile) const { return (*lists_[tile / neighbours])[tile % neighbours]; }
  void reset(std::size_t tiles);
  List& grow(std::size_t tile); // the tile's list, with room for an entry
  TileEntry* allocate(std::size_t entries);
  std::size_t bytes() const;

  // The first block holds 16 KiB, each further one twice as much, up to 256 KiB: of many runs some list little.
  static constexpr std::size_t block_entries(std::size_t block) {
    return std::size_t{1} << (10 + std::min<std::size_t>(block, 4));
  }
  std::vector<Lists*> lists_; // of each so many neighbours
  std::vector<std::unique_ptr<Lists>> rooms_;
  std::size_t used_rooms_ = 0;
  std::vector<std::unique_ptr<TileEntry[]>> blocks_;
  std::size_t block_ = 0, used_ = 0; // where the next chunk goes
};

inline TileLists::Run& TileLists::run(std::size_t i) {
  return runs_[i];
}

template <class Body>
void TileLists::for_each_piece(std::size_t tile, Body&& body) const {
  for (std::size_t i = 0; i < used_; ++i) {
    const List& list = runs_[i].list_of(tile);
    for (Chunk* chunk = list.first; chunk; chunk = chunk->next) {
      const TileEntry* const begin = chunk->entries();
      body(std::span(begin, chunk == list.last ? list.next : begin + chunk->capacity));
    }
  }
}

} // namespace refraster
