#include "verify/block_compression.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace refraster {
namespace {

constexpr int side = 8;
using Block = std::array<double, std::size_t{side} * side>;

/// Orthonormal DCT-II of each row, transposed: done twice, it is that of the block.
Block rows_transformed(const Block& block) {
  static const Block cosines = [] {
    Block table;
    for (int k = 0; k < side; ++k)
      for (int i = 0; i < side; ++i)
        table[static_cast<std::size_t>(side * k + i)] =
            std::sqrt((k == 0 ? 1.0 : 2.0) / side) * std::cos(std::numbers::pi * k * (2 * i + 1) / (2 * side));
    return table;
  }();
  Block result;
  for (std::size_t y = 0; y < side; ++y)
    for (std::size_t k = 0; k < side; ++k) {
      double sum = 0;
      for (std::size_t i = 0; i < side; ++i) sum += block[side * y + i] * cosines[side * k + i];
      result[side * k + y] = sum;
    }
  return result;
}

double luma(const StoredImage& image, int x, int y) {
  if (image.image.channels < 3) return image.levels(x, y, 0);
  return 0.299 * image.levels(x, y, 0) + 0.587 * image.levels(x, y, 1) + 0.114 * image.levels(x, y, 2);
}

/// Three standard deviations of a coefficient of pixels that are rounded to a level: each channel is off by up to half
/// of one, 1/12 in the square, and an orthonormal transform leaves the sum of squares as it is.
double zero_below(int channels) {
  const double weights = channels < 3 ? 1 : 0.299 * 0.299 + 0.587 * 0.587 + 0.114 * 0.114;
  return 3 * std::sqrt(weights / 12);
}

Block coefficients(const StoredImage& image, int left, int top) {
  Block block;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) block[static_cast<std::size_t>(side * y + x)] = luma(image, left + x, top + y);
  return rows_transformed(rows_transformed(block));
}

bool differ(const StoredImage& a, const StoredImage& b, int left, int top) {
  for (int y = top; y < top + side; ++y)
    for (int x = left; x < left + side; ++x)
      if (std::abs(luma(a, x, y) - luma(b, x, y)) > 0) return true;
  return false;
}

} // namespace

BlockZeros block_zeros(const StoredImage& a, const StoredImage& b) {
  constexpr std::array<std::array<int, 2>, 4> grids = {{{0, 0}, {4, 0}, {0, 4}, {4, 4}}};
  constexpr std::uint64_t most_blocks = (1 << 20) / (side * side);
  const double zero = zero_below(a.image.channels);
  const int columns = (a.image.width - side / 2) / side, rows = (a.image.height - side / 2) / side;
  BlockZeros found;
  if (columns <= 0 || rows <= 0) return found;
  const std::uint64_t all = static_cast<std::uint64_t>(columns) * static_cast<std::uint64_t>(rows);
  const std::uint64_t stride = (all / most_blocks + 1) | 1; // odd, so as not to see the same columns of all rows
  std::array<double, grids.size()> gain{};
  for (std::uint64_t i = 0; i < all; i += stride) {
    const int left = static_cast<int>(i % static_cast<std::uint64_t>(columns)) * side;
    const int top = static_cast<int>(i / static_cast<std::uint64_t>(columns)) * side;
    if (!differ(a, b, left, top)) continue;
    ++found.blocks;
    for (std::size_t grid = 0; grid < grids.size(); ++grid) {
      const Block of_a = coefficients(a, left + grids[grid][0], top + grids[grid][1]);
      const Block of_b = coefficients(b, left + grids[grid][0], top + grids[grid][1]);
      for (std::size_t k = 1; k < of_a.size(); ++k) // the first is the mean
        gain[grid] += (std::abs(of_b[k]) < zero) - (std::abs(of_a[k]) < zero);
    }
  }
  if (found.blocks == 0) return found;
  for (double& g : gain) g /= static_cast<double>(found.blocks) * (side * side - 1);
  found.on_grid = gain[0];
  found.beside = *std::max_element(gain.begin() + 1, gain.end());
  return found;
}

Compressed find_block_compression(const StoredImage& a, const StoredImage& b) {
  // Fewer blocks may look like anything. A coefficient is zero by chance in some hundredths, on all grids alike.
  constexpr std::uint64_t least_blocks = 16;
  constexpr double least_excess = 0.1;
  const auto follows = [&](const StoredImage& from, const StoredImage& to) {
    const BlockZeros zeros = block_zeros(from, to);
    return zeros.blocks >= least_blocks && zeros.on_grid > 0 && zeros.on_grid - zeros.beside >= least_excess;
  };
  if (follows(a, b)) return Compressed::b;
  if (follows(b, a)) return Compressed::a;
  return Compressed::none;
}

} // namespace refraster
