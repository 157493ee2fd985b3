#include "verify/transformations/block_compression.h"

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

/// How many coefficients are not zero, but for the first: that is the mean.
double not_zero(const Block& block, double zero) {
  return static_cast<double>(
      std::count_if(block.begin() + 1, block.end(), [&](double value) { return std::abs(value) >= zero; }));
}

bool differ(const StoredImage& a, const StoredImage& b, int left, int top) {
  for (int y = top; y < top + side; ++y)
    for (int x = left; x < left + side; ++x)
      if (std::abs(luma(a, x, y) - luma(b, x, y)) > 0) return true;
  return false;
}

} // namespace

BlockSpectrum block_spectrum(const StoredImage& a, const StoredImage& b) {
  constexpr std::array<std::array<int, 2>, 4> grids = {{{0, 0}, {4, 0}, {0, 4}, {4, 4}}};
  constexpr std::uint64_t max_blocks = (1 << 20) / (side * side);
  const double zero = zero_below(a.image.channels);
  const int columns = (a.image.width - side / 2) / side, rows = (a.image.height - side / 2) / side;
  BlockSpectrum found;
  if (columns <= 0 || rows <= 0) return found;
  const std::uint64_t all = static_cast<std::uint64_t>(columns) * static_cast<std::uint64_t>(rows);
  const std::uint64_t stride = (all / max_blocks + 1) | 1; // odd, so as not to see the same columns of all rows
  std::array<double, grids.size()> in_a{}, in_b{};         // coefficients that are not zero
  for (std::uint64_t i = 0; i < all; i += stride) {
    const int left = static_cast<int>(i % static_cast<std::uint64_t>(columns)) * side;
    const int top = static_cast<int>(i / static_cast<std::uint64_t>(columns)) * side;
    if (!differ(a, b, left, top)) continue;
    std::array<std::array<double, 2>, grids.size()> of_block{}; // of a, of b
    for (std::size_t grid = 0; grid < grids.size(); ++grid) {
      const int x = left + grids[grid][0], y = top + grids[grid][1];
      of_block[grid] = {not_zero(coefficients(a, x, y), zero), not_zero(coefficients(b, x, y), zero)};
    }
    if (of_block[0][1] == 0) continue; // a square of one colour may be drawn so
    ++found.blocks;
    for (std::size_t grid = 0; grid < grids.size(); ++grid)
      in_a[grid] += of_block[grid][0], in_b[grid] += of_block[grid][1];
  }
  // One is added, so that few coefficients tell little, and none nothing.
  const auto fraction = [&](std::size_t grid) { return (in_b[grid] + 1) / (in_a[grid] + 1); };
  found.on_grid = fraction(0);
  found.beside = std::min({fraction(1), fraction(2), fraction(3)});
  return found;
}

Compressed find_block_compression(const StoredImage& a, const StoredImage& b) {
  // Fewer blocks may look like anything.
  constexpr std::uint64_t min_blocks = 16;
  constexpr double max_on_grid = 0.8;
  const auto follows = [&](const StoredImage& from, const StoredImage& to) {
    const BlockSpectrum spectrum = block_spectrum(from, to);
    return spectrum.blocks >= min_blocks && spectrum.on_grid < 1 && spectrum.on_grid < max_on_grid * spectrum.beside;
  };
  if (follows(a, b)) return Compressed::b;
  if (follows(b, a)) return Compressed::a;
  return Compressed::none;
}

} // namespace refraster
