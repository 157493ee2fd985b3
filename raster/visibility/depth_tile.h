#pragma once
// The nearest depth and triangle of each sample of a tile, and bounds of the depths of its blocks.

#include <refraster/render.h>

#include "raster/lanes.h"

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

namespace refraster {

/// No triangle: the sample sees the background.
inline constexpr std::int32_t nothing = -1;

/// Triangles may come in any order: of equal depths the one with the lowest slot is seen.
class DepthTile {
public:
  using Row = Native<double>; // as many neighbouring samples as a register holds
  static constexpr int lanes = NumberTraits<Row>::lanes;

  explicit DepthTile(int tile_size);

  /// Every sample sees nothing.
  void clear(const PixelRect& tile, std::size_t samples);

  /// Where sample `s` of the pixel (x, y) is, counted from the tile's corner. Its neighbours in the row follow, and
  /// after the row's last pixel there is room for a register, which may be read and written; what it holds means
  /// nothing.
  std::size_t at(int s, int x, int y) const {
    return (static_cast<std::size_t>(s) * rows_ + static_cast<std::size_t>(y)) * stride_ + static_cast<std::size_t>(x);
  }
  double depth(std::size_t sample) const { return depth_[sample]; }
  std::int32_t nearest(std::size_t sample) const { return nearest_[sample]; }
  const std::int32_t* nearest_row(std::size_t sample) const { return &nearest_[sample]; }

  void depth_test_and_write(std::size_t sample, double z, std::int32_t slot) {
    if (z < depth_[sample] || (z == depth_[sample] && slot < nearest_[sample])) {
      depth_[sample] = z;
      nearest_[sample] = slot;
    }
  }
  /// The same without a branch: for triangles that come in any order, so that no one can guess what is nearer.
  void depth_test_and_write_unguessed(std::size_t sample, double z, std::int32_t slot) {
    const double old = depth_[sample];
    const std::int32_t seen = nearest_[sample];
    const auto nearer = -static_cast<std::int64_t>((z < old) | ((z == old) & (slot < seen)));
    const auto bits = std::bit_cast<std::int64_t>(old);
    depth_[sample] = std::bit_cast<double>(bits ^ ((bits ^ std::bit_cast<std::int64_t>(z)) & nearer));
    nearest_[sample] = seen ^ ((seen ^ slot) & static_cast<std::int32_t>(nearer));
  }
  /// Samples of a row, from one of them on.
  struct Samples {
    double* depth;
    std::int32_t* nearest;
    Samples operator+(int pixels) const { return {depth + pixels, nearest + pixels}; }
    /// The same for a register of them, where `covered` is set.
    void depth_test_and_write(const Row& z, MaskOf<Row> covered, std::int32_t slot) const;
  };
  Samples samples(std::size_t first) { return {&depth_[first], &nearest_[first]}; }

  /// Updates the bounds: is_occluded() accounts for what was drawn before.
  void refresh_bounds();
  /// All samples of these pixels, ends included, are known to be nearer than z.
  bool is_occluded(int left, int top, int right, int bottom, double z) const {
    return !(tile_bound_ >= z) || (tile_bound_ < unbounded && are_blocks_occluded(left, top, right, bottom, z));
  }

private:
  // Bounds: none of the samples lies behind. Of `block` pixels one above the other; of as many of these side by side;
  // of the whole tile, which is all that most triangles ask for that lie behind others.
  static constexpr int block = 8;
  static constexpr double unbounded = std::numeric_limits<double>::infinity();
  using Slots = VectorOf<std::int32_t, lanes>;

  bool are_blocks_occluded(int left, int top, int right, int bottom, double z) const;
  std::size_t column_at(int block_row, int x) const {
    return static_cast<std::size_t>(block_row) * stride_ + static_cast<std::size_t>(x);
  }
  std::size_t block_at(int block_row, int column) const {
    return static_cast<std::size_t>(block_row) * (rows_ / block) + static_cast<std::size_t>(column);
  }

  std::size_t rows_, stride_;
  std::size_t samples_ = 0;
  int width_ = 0, height_ = 0; // of the tile
  double tile_bound_ = unbounded;
  std::vector<double> depth_, column_bound_, block_bound_;
  std::vector<std::int32_t> nearest_;
};

inline void DepthTile::Samples::depth_test_and_write(const Row& z, MaskOf<Row> covered, std::int32_t slot) const {
  const Row old = load_lanes<Row>(depth);
  auto seen = covered & (z < old);
  const auto tie = covered & (z == old);
  if (any(tie)) [[unlikely]] {
    seen = seen | (tie & (Row(static_cast<double>(slot)) < numbers<lanes>(load_lanes<Slots>(nearest))));
  }
  store_lanes(depth, select(seen, z, old));
#if defined(__AVX512VL__)
  if constexpr (lanes == 8) {
    _mm256_mask_storeu_epi32(nearest, static_cast<__mmask8>(lane_set(seen)), _mm256_set1_epi32(slot));
    return;
  }
#endif
  const Slots where = __builtin_convertvector(lane_bits(seen), Slots);
  store_lanes(nearest, where ? slot - Slots{} : load_lanes<Slots>(nearest));
}

} // namespace refraster
