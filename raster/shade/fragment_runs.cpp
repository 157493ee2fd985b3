#include "raster/shade/fragment_runs.h"

#include "raster/lanes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>

namespace refraster {

namespace {

constexpr int lanes = native_vector_bytes >= 32 ? 8 : 4; // divides every tile size
using Slots = VectorOf<std::int32_t, lanes>;
using PixelSet = std::uint64_t; // a bit for each of 64 pixels, the leftmost the lowest
constexpr int pixels_of_set = 64;

// A row of a tile: what each sample of its pixels sees. After the last pixel there is room for another.
struct SlotRow {
  std::array<const std::int32_t*, 16> sample;
  int samples = 0, width = 0;

  Slots slots(int s, int x) const { return load_lanes<Slots>(sample[static_cast<std::size_t>(s)] + x); }

  // Of the pixels from `first` on: where the first samples of a pixel and of its right neighbour see different things.
  // What lies beyond the row means nothing.
  PixelSet changes(int first) const {
    return set_of(first, [&](int x) { return slots(0, x) != slots(0, x + 1); });
  }
  // Where samples of one pixel see different things.
  PixelSet mixed(int first) const {
    return set_of(first, [&](int x) {
      const Slots seen = slots(0, x);
      Slots differ = slots(1, x) ^ seen;
      for (int s = 2; s < samples; ++s) differ |= slots(s, x) ^ seen;
      return differ != 0;
    });
  }

private:
  template <class Holds>
  PixelSet set_of(int first, const Holds& holds) const {
    PixelSet set = 0;
    for (int x = first; x < std::min(first + pixels_of_set, width); x += lanes)
      set |= PixelSet{negative_lanes(holds(x))} << (x - first);
    return set;
  }
};

struct RunList {
  std::vector<FragmentRun>& runs;
  std::uint8_t y;
  std::uint8_t samples;

  void add(std::int32_t slot, int begin, int end) const {
    if (slot == nothing) return;
    runs.push_back({slot, 0, static_cast<std::uint8_t>(begin), y, static_cast<std::uint8_t>(end - begin), samples});
  }
  // A pixel whose samples see different things.
  void add_mixed(const SlotRow& row, int x) const {
    const std::size_t first = runs.size();
    for (int s = 0; s < samples; ++s) {
      const std::int32_t slot = row.sample[static_cast<std::size_t>(s)][x];
      if (slot == nothing) continue;
      const auto same = std::find_if(runs.begin() + static_cast<std::ptrdiff_t>(first), runs.end(),
                                     [=](const FragmentRun& run) { return run.slot == slot; });
      if (same != runs.end()) ++same->samples;
      else runs.push_back({slot, 0, static_cast<std::uint8_t>(x), y, 1, 1});
    }
  }
};

// Calls body(begin, end) with the row's parts from one end to the next. ends(x): a bit for each pixel from x on after
// which a part ends.
void for_each_part(int width, auto&& ends, auto&& body) {
  int begin = 0;
  for (int first = 0; first < width; first += pixels_of_set) {
    PixelSet set = ends(first);
    const int rest = width - first;
    if (rest <= pixels_of_set) set = (set & (~PixelSet{0} >> (pixels_of_set - rest))) | PixelSet{1} << (rest - 1);
    for (; set; set &= set - 1) {
      const int end = first + std::countr_zero(set) + 1;
      body(begin, end);
      begin = end;
    }
  }
}

} // namespace

void list_runs(const TileVisibility& visibility, const PixelRect& tile, int samples, std::vector<FragmentRun>& runs) {
  runs.clear();
  SlotRow row;
  row.samples = samples, row.width = tile.width;
  for (int y = 0; y < tile.height; ++y) {
    for (int s = 0; s < samples; ++s) row.sample[static_cast<std::size_t>(s)] = visibility.row(s, y);
    const RunList list{runs, static_cast<std::uint8_t>(y), static_cast<std::uint8_t>(samples)};
    const std::int32_t* const seen = row.sample[0];
    if (samples == 1) {
      for_each_part(
          tile.width, [&](int first) { return row.changes(first); },
          [&](int begin, int end) { list.add(seen[begin], begin, end); });
      continue;
    }
    // A mixed pixel is a part by itself: a part ends after it, and before it.
    std::array<PixelSet, 3> mixed{}; // a tile has at most 128 pixels a side
    for (int first = 0; first < tile.width; first += pixels_of_set)
      mixed[static_cast<std::size_t>(first / pixels_of_set)] = row.mixed(first);
    for_each_part(
        tile.width,
        [&](int first) {
          const auto at = static_cast<std::size_t>(first / pixels_of_set);
          const PixelSet before = mixed[at] >> 1 | mixed[at + 1] << (pixels_of_set - 1);
          return row.changes(first) | mixed[at] | before;
        },
        [&](int begin, int end) {
          const auto at = static_cast<std::size_t>(begin / pixels_of_set);
          if (mixed[at] >> (begin % pixels_of_set) & 1) list.add_mixed(row, begin);
          else list.add(seen[begin], begin, end);
        });
  }
}

} // namespace refraster
