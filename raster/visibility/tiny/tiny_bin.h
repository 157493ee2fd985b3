#pragma once
// What becomes of registers of tiny triangles in a frame of one sample a pixel: which are seen, and where.

#include "raster/visibility/bin.h"
#include "raster/visibility/tiny/tiny_triangles.h"

#include <array>
#include <bit>
#include <cstdint>

namespace refraster {

/// Bins registers of triangles by the rules of Binner, to the same lists and counts.
class TinyBinner {
public:
  static constexpr int half = NumberTraits<Native<double>>::lanes, lanes = 2 * half;
  using Ints = VectorOf<std::int32_t, lanes>;

  explicit TinyBinner(const TileGrid& grid, const SamplePosition& sample)
      : grid_(grid), sample_(sample), columns_(grid.columns()),
        tile_shift_(std::countr_zero(static_cast<unsigned>(grid.tile_size))) {}

  /// What is listed of a register: samples of `small`, boxes of the others that are `drawn`.
  struct Binned {
    std::uint32_t drawn = 0, small = 0; // a bit a lane
    std::uint64_t covered = 0;          // bit 4 lane + i: sample i of TinyCoverage
    // Of sample i.
    std::array<std::array<std::int32_t, lanes>, 4> tile, place;
    std::array<std::array<double, lanes>, 4> z;
    // Boxes in pixels of the grid, ends included, and the least of the corners' depths: set where not all are small.
    std::array<std::int32_t, lanes> left, top, right, bottom;
    std::array<double, lanes> z_min;
  };

  /// False, and nothing done, where not all triangles are tiny. vertex(k, lane): corner k of the triangle in that lane.
  /// Lanes from `count` on are read too, must be tiny, and are not listed: they may repeat one that is.
  template <class Vertex>
  bool bin(const Vertex& vertex, std::uint32_t count, Cull cull, FrameCounts& counts, Binned& binned) const {
    Ints x_sides[3], y_state[3];
    Depths z;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto low = gather_pairs<half>([&](int lane) { return &vertex(k, lane); });
      const auto high = gather_pairs<half>([&](int lane) { return &vertex(k, half + lane); });
      part_words<lanes, 2>({low[0], high[0]}, x_sides[k], y_state[k]);
      z[k] = {low[1], high[1]};
    }
    const TinyTriangles<lanes> t(x_sides, y_state);
    if (!t.fit) return false;
    const Ints sides_of_all = x_sides[0] & x_sides[1] & x_sides[2] & outcode::sides;
    const Ints sides_of_any = x_sides[0] | x_sides[1] | x_sides[2];

    // Each lane leaves at the first reason to.
    std::uint32_t left = static_cast<std::uint32_t>((std::uint64_t{1} << count) - 1);
    const auto leave = [&left](std::uint32_t set) {
      const auto leaving = static_cast<std::uint64_t>(std::popcount(left & set));
      left &= ~set;
      return leaving;
    };
    counts.outside += leave(negative_lanes(-sides_of_all));
    const Ints area = t.area();
    counts.degenerate += leave(~negative_lanes(area | -area));
    if (cull == Cull::back) counts.culled += leave(negative_lanes(-area));
    // The pixels p with x_min <= 256 p + sample <= x_max.
    const auto ceiling = [](const Ints& x) { return (x + (subpixels - 1)) >> 8; };
    Ints box_left = ceiling(t.x_min - sample_.x) - grid_.x, box_right = ((t.x_max - sample_.x) >> 8) - grid_.x;
    Ints box_top = ceiling(t.y_min - sample_.y) - grid_.y, box_bottom = ((t.y_max - sample_.y) >> 8) - grid_.y;
    const auto empty = [&] { return negative_lanes((box_right - box_left) | (box_bottom - box_top)); };
    counts.between_samples += leave(empty());
    const Ints zero{};
    box_left = greater(box_left, zero), box_right = lesser(box_right, zero + (grid_.width - 1));
    box_top = greater(box_top, zero), box_bottom = lesser(box_bottom, zero + (grid_.height - 1));
    counts.outside += leave(empty());
    counts.drawn += static_cast<std::uint64_t>(std::popcount(left));
    counts.clipped += static_cast<std::uint64_t>(
        std::popcount(left & negative_lanes(-(sides_of_any & (outcode::near | outcode::far)))));

    const Ints wider = box_right - box_left, higher = box_bottom - box_top; // by pixels than one
    binned.drawn = left;
    binned.small = left & ~negative_lanes((1 - wider) | (1 - higher));
    binned.covered = 0;
    if (binned.small) set_samples(t, z, box_left, box_top, wider, higher, binned);
    if (binned.small != left) {
      store_lanes(binned.left.data(), box_left), store_lanes(binned.right.data(), box_right);
      store_lanes(binned.top.data(), box_top), store_lanes(binned.bottom.data(), box_bottom);
      for (std::size_t h = 0; h < 2; ++h) store_lanes(&binned.z_min[h * half], min(z[0][h], min(z[1][h], z[2][h])));
    }
    return true;
  }

private:
  using Depths = std::array<std::array<Native<double>, 2>, 3>; // of corners, in two halves

  // Bit k of a number moved to bit 4 k: so the sets of four samples become, for each triangle, four bits of its own.
  static std::uint64_t every_fourth(std::uint32_t set) {
    static constexpr auto spread = [] {
      std::array<std::uint32_t, 256> of{};
      for (std::uint32_t byte = 0; byte < of.size(); ++byte)
        for (std::uint32_t bit = 0; bit < 8; ++bit) of[byte] |= (byte >> bit & 1) << 4 * bit;
      return of;
    }();
    static_assert(lanes <= 16);
    return spread[set & 255] | std::uint64_t{spread[set >> 8]} << 32;
  }

  void set_samples(const TinyTriangles<lanes>& t, const Depths& z, const Ints& left, const Ints& top, const Ints& wider,
                   const Ints& higher, Binned& binned) const {
    const auto coverage =
        cover_tiny<lanes>(t, z, (left + grid_.x) * subpixels + sample_.x, (top + grid_.y) * subpixels + sample_.y);
    // Beyond the box, which the grid may have cut, there is nothing.
    const std::uint32_t two_wide = negative_lanes(-wider), two_high = negative_lanes(-higher);
    const std::array<std::uint32_t, 4> within{binned.small, binned.small & two_wide, binned.small & two_high,
                                              binned.small & two_wide & two_high};
    for (int i = 0; i < 4; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const Ints x = left + (i & 1), y = top + (i >> 1);
      const std::int32_t in_tile = grid_.tile_size - 1;
      store_lanes(binned.tile[at].data(), (y >> tile_shift_) * columns_ + (x >> tile_shift_));
      store_lanes(binned.place[at].data(),
                  (x & in_tile) | (y & in_tile) << 8 |
                      static_cast<std::int32_t>(TileEntry::bytes(0, 0, TileEntry::sample_mark, 0)));
      for (std::size_t h = 0; h < 2; ++h) store_lanes(&binned.z[at][h * half], coverage.z[at][h]);
      binned.covered |= every_fourth(coverage.lanes[at] & within[at]) << i;
    }
  }

  TileGrid grid_;
  SamplePosition sample_;
  int columns_, tile_shift_;
};

} // namespace refraster
