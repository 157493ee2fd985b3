#include "raster/visibility/draw_projective.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace refraster {

namespace {

using Row = DepthTile::Row;
constexpr int lanes = DepthTile::lanes;

// Along a row an edge function's value is V + x A, x in pixels, with V and A integers of up to 110 bits;
// ProjectivePiece rounds it to double. Here it is the sum of two doubles: `high`, a multiple of u = 2^e, which is
// exact, and `low`, which is not.
//
// u is chosen so that values in the tile are under 2^51 u; so high, off by the rest of V and x <= 136 times that of A,
// is a multiple of u under 2^52 u. The rests are at most u / 2, low is at most 69 u, and each of the roundings that it
// goes through is of a number under 2^7 u: four of them are less than 2^-43 u = `doubt` in all. Where high + (low +
// doubt) and high + (low - doubt) round to one number, so does the true value, which lies between: but for samples that
// all but lie on the line. Those are looked at alone. If e = 0 there is no rest and no doubt.
struct EdgeRow {
  double high = 0, low = 0; // at the tile's left sample
};
struct TileEdge {
  ProjectiveEdge edge;
  int e = 0;
  double u = 1, doubt = 0,
         threshold = 0;               // covered where the value is greater than `threshold`; values are whole numbers
  double high_step = 0, low_step = 0; // by a pixel

  // largest: of the magnitudes in the tile, and of the register's width beyond it.
  TileEdge(const ProjectiveEdge& of, Int128 largest) : edge(of), threshold(of.owns_ties() ? -0.5 : 0.0) {
    const auto high_bits = static_cast<std::uint64_t>(largest >> 51); // largest is under 2^115
    e = high_bits == 0 ? 0 : 64 - std::countl_zero(high_bits);
    u = static_cast<double>(Int128{1} << e);
    doubt = e == 0 ? 0 : u * 0x1p-43;
    const EdgeRow step = split(static_cast<Int128>(edge.a) * subpixels);
    high_step = step.high, low_step = step.low;
  }

  EdgeRow row(std::int32_t x, std::int32_t y) const { return split(edge.at(x, y)); }

private:
  EdgeRow split(Int128 value) const {
    const Int128 half = e == 0 ? Int128{0} : Int128{1} << (e - 1);
    const Int128 units = (value + half) >> e;
    return {static_cast<double>(static_cast<std::int64_t>(units)) * u,
            static_cast<double>(static_cast<std::int64_t>(value - (units << e)))};
  }
};

// Pixels of a row, or rows, ends included.
struct Range {
  int first, last;
  bool is_empty() const { return first > last; }
};

// Where an edge function can be positive, or 0, in the tile: in doubles, never too narrow. They have a pixel's offset
// from the tile's first sample for x and y.
//
// Let L be the largest magnitude of the function in the tile. Of doubles near its value at the first sample and its
// steps, the sum start + x right + y down is off by less than 8 2^-53 L, and a quotient of such a sum and a step by as
// much as if the sum were off by another 5 2^-53 L: |x right| and |y down| are differences of two values, at most 2 L.
// That is less than 2^-49 L, and a half is less than 1: what is not above -reach is nowhere covered.
class Strip {
public:
  Strip(const ProjectiveEdge& edge, std::int32_t x, std::int32_t y, Int128 largest)
      : start_(static_cast<double>(edge.at(x, y))), right_(static_cast<double>(edge.a) * subpixels),
        down_(static_cast<double>(edge.b) * subpixels), reach_(static_cast<double>(largest) * 0x1p-49 + 1) {
    if (right_ != 0) reciprocal_ = 1 / right_;
  }

  // Of the rows of a tile of this width.
  void narrow_rows(int width, Range& rows) const {
    const double most = start_ + max(right_ * (width - 1), 0.0);
    if (down_ == 0) narrow_level(most, rows);
    else narrow(down_ > 0, -(most + reach_) / down_, rows);
  }
  // Of the pixels of a row.
  void narrow_pixels(int y, Range& pixels) const {
    const double value = start_ + y * down_;
    if (right_ == 0) narrow_level(value, pixels);
    else narrow(right_ > 0, -(value + reach_) * reciprocal_, pixels);
  }

private:
  void narrow_level(double value, Range& range) const {
    if (value + reach_ < 0) range = {0, -1};
  }
  // To what lies beyond `at`, or before it.
  static void narrow(bool is_beyond, double at, Range& range) {
    constexpr double outside = 1 << 20; // of every tile, and of no int
    const double inside = min(max(at, -outside), outside);
    if (is_beyond) range.first = std::max(range.first, static_cast<int>(std::floor(inside)));
    else range.last = std::min(range.last, static_cast<int>(std::ceil(inside)));
  }

  double start_, right_, down_, reach_, reciprocal_ = 0;
};

void draw_piece(const ProjectivePiece& piece, std::int32_t slot, const PixelRect& tile, SamplePosition sample, int s,
                DepthTile& depths) {
  const std::int32_t x_first = tile.x * subpixels + sample.x, y_first = tile.y * subpixels + sample.y;
  const std::int32_t x_end = x_first + (tile.width + lanes) * subpixels, y_end = y_first + tile.height * subpixels;
  const auto largest = [&](std::size_t k) {
    const ProjectiveEdge& edge = piece.edge[k];
    return std::max(edge.max_over(x_first, y_first, x_end, y_end), (-edge).max_over(x_first, y_first, x_end, y_end));
  };
  const std::array<Int128, 3> bound{largest(0), largest(1), largest(2)};
  const auto strip = [&](std::size_t k) { return Strip(piece.edge[k], x_first, y_first, bound[k]); };
  const std::array<Strip, 3> strips{strip(0), strip(1), strip(2)};
  Range rows{0, tile.height - 1};
  for (const Strip& one : strips) one.narrow_rows(tile.width, rows);
  if (rows.is_empty()) return;

  const std::array<TileEdge, 3> edges{TileEdge(piece.edge[0], bound[0]), TileEdge(piece.edge[1], bound[1]),
                                      TileEdge(piece.edge[2], bound[2])};
  for (int y = rows.first; y <= rows.last; ++y) {
    Range pixels{0, tile.width - 1};
    for (const Strip& one : strips) one.narrow_pixels(y, pixels);
    if (pixels.is_empty()) continue;
    const std::int32_t y_sample = y_first + y * subpixels;
    std::array<EdgeRow, 3> row;
    for (std::size_t k = 0; k < 3; ++k) row[k] = edges[k].row(x_first, y_sample);
    const DepthTile::Samples samples = depths.samples(depths.at(s, 0, y));
    for (int x = pixels.first; x <= pixels.last; x += lanes) {
      const Row pixel = lane_numbers<double, lanes>() + Row(static_cast<double>(x));
      std::array<Row, 3> value;
      auto covered = pixel < Row(static_cast<double>(tile.width)), sure = covered;
      for (std::size_t k = 0; k < 3; ++k) {
        const TileEdge& tile_edge = edges[k];
        const Row high = Row(row[k].high) + pixel * Row(tile_edge.high_step),
                  low = Row(row[k].low) + pixel * Row(tile_edge.low_step);
        value[k] = high + (low + Row(tile_edge.doubt));
        sure = sure & (value[k] == high + (low - Row(tile_edge.doubt)));
        covered = covered & (value[k] > Row(tile_edge.threshold));
      }
      const std::uint32_t unsure = lane_set(pixel < Row(static_cast<double>(tile.width))) & ~lane_set(sure);
      if (any(covered & sure)) {
        // The same operations as ProjectivePiece::depth.
        Row z_sum(0.0), w_sum(0.0);
        for (std::size_t k = 0; k < 3; ++k) {
          const Row nu = value[k] * Row(piece.weight[k]);
          z_sum += nu * Row(piece.z[k]);
          w_sum += nu * Row(piece.w[k]);
        }
        const Row z = z_sum / w_sum;
        (samples + x).depth_test_and_write(z, covered & sure & (z >= Row(-1.0)), slot);
      }
      if (unsure) [[unlikely]] {
        for (int lane = 0; lane < lanes; ++lane) {
          const std::int32_t x_sample = x_first + (x + lane) * subpixels;
          if (!(unsure >> lane & 1) || !piece.covers(x_sample, y_sample)) continue;
          const double z = piece.depth(x_sample, y_sample);
          if (z >= -1) depths.depth_test_and_write(depths.at(s, x + lane, y), z, slot);
        }
      }
    }
  }
}

} // namespace

void draw_projective(const ProjectiveTriangle& triangle, std::int32_t slot, const PixelRect& tile,
                     std::span<const SamplePosition> samples, DepthTile& depths) {
  for (std::size_t s = 0; s < samples.size(); ++s)
    for (std::size_t i = 0; i < static_cast<std::size_t>(triangle.pieces); ++i)
      draw_piece(triangle.piece[i], slot, tile, samples[s], static_cast<int>(s), depths);
}

} // namespace refraster
