#include "raster/visibility/draw_projective.h"

#include <algorithm>
#include <array>

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

  // x, y: the first sample; x_end, y_end: beyond the last one.
  TileEdge(const ProjectiveEdge& of, std::int32_t x, std::int32_t y, std::int32_t x_end, std::int32_t y_end)
      : edge(of), threshold(of.owns_ties() ? -0.5 : 0.0) {
    const Int128 largest = std::max(edge.max_over(x, y, x_end, y_end), (-edge).max_over(x, y, x_end, y_end));
    while ((largest >> e) >= Int128{1} << 51) ++e;
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

void draw_piece(const ProjectivePiece& piece, std::int32_t slot, const PixelRect& tile, SamplePosition sample, int s,
                DepthTile& depths) {
  const std::int32_t x_first = tile.x * subpixels + sample.x, y_first = tile.y * subpixels + sample.y;
  const auto edge = [&](std::size_t k) {
    return TileEdge(piece.edge[k], x_first, y_first, x_first + (tile.width + lanes) * subpixels,
                    y_first + tile.height * subpixels);
  };
  const std::array<TileEdge, 3> edges{edge(0), edge(1), edge(2)};
  for (int y = 0; y < tile.height; ++y) {
    const std::int32_t y_sample = y_first + y * subpixels;
    std::array<EdgeRow, 3> row;
    for (std::size_t k = 0; k < 3; ++k) row[k] = edges[k].row(x_first, y_sample);
    const DepthTile::Samples samples = depths.samples(depths.at(s, 0, y));
    for (int x = 0; x < tile.width; x += lanes) {
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
