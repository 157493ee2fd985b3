#pragma once
// Which tiles a large triangle may touch: those beside a long thin one are ruled out by its edge functions.

#include "raster/visibility/bin.h"
#include "raster/visibility/setup.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace refraster {

class TouchedTiles {
public:
  /// `samples`: of each pixel.
  TouchedTiles(const TileGrid& grid, std::span<const SamplePosition> samples) : grid_(grid) {
    const auto [x_low, x_high] =
        std::minmax_element(samples.begin(), samples.end(), [](auto& p, auto& q) { return p.x < q.x; });
    const auto [y_low, y_high] =
        std::minmax_element(samples.begin(), samples.end(), [](auto& p, auto& q) { return p.y < q.y; });
    first_x = x_low->x, last_x = x_high->x, first_y = y_low->y, last_y = y_high->y;
  }

  std::int32_t first_x = 0, last_x = 0, first_y = 0, last_y = 0; // the sample pattern's extent in a pixel

  /// Whether any sample of these pixels may be on the inner side of every edge.
  template <class Edges>
  bool edges_touch(const Edges& edges, const PixelRect& c) const {
    const std::int32_t x0 = c.x * subpixels + first_x, x1 = (c.x + c.width - 1) * subpixels + last_x;
    const std::int32_t y0 = c.y * subpixels + first_y, y1 = (c.y + c.height - 1) * subpixels + last_y;
    return edges[0].max_over(x0, y0, x1, y1) >= 0 && edges[1].max_over(x0, y0, x1, y1) >= 0 &&
           edges[2].max_over(x0, y0, x1, y1) >= 0;
  }
  bool touches(const ProjectiveTriangle& triangle, const PixelRect& pixels) const {
    return edges_touch(triangle.piece[0].edge, pixels) ||
           (triangle.pieces == 2 && edges_touch(triangle.piece[1].edge, pixels));
  }

  /// Tiles by their columns and rows, ends included.
  struct Range {
    int left, top, right, bottom;
  };

  /// Calls body(column, row) with those in `range` that edges_touch(), row by row: a register of tiles at once, in
  /// double, where their values are exact (raster/vertex/subpixel.h).
  template <class Body>
  void for_each(const std::array<SnappedEdge, 3>& edges, const Range& range, Body&& body) const {
    using Row = Native<double>;
    constexpr int lanes = NumberTraits<Row>::lanes;
    const int size = grid_.tile_size, last_column = grid_.x + grid_.width - 1, last_row = grid_.y + grid_.height - 1;
    for (int row = range.top; row <= range.bottom; ++row) {
      const int top = grid_.y + row * size, bottom = std::min(top + size - 1, last_row);
      const std::int64_t y0 = top * subpixels + first_y, y1 = bottom * subpixels + last_y;
      for (int first = range.left; first <= range.right; first += lanes) {
        const Row left = Row(static_cast<double>(grid_.x + first * size)) +
                         lane_numbers<double, lanes>() * Row(static_cast<double>(size));
        const Row right = min(left + Row(static_cast<double>(size - 1)), Row(static_cast<double>(last_column)));
        const Row x0 = left * Row(double{subpixels}) + Row(static_cast<double>(first_x));
        const Row x1 = right * Row(double{subpixels}) + Row(static_cast<double>(last_x));
        Row least(0.0);
        for (const SnappedEdge& edge : edges) {
          const Row of_row(static_cast<double>(edge.b * (edge.b > 0 ? y1 : y0) + edge.c));
          least = min(least, Row(static_cast<double>(edge.a)) * (edge.a > 0 ? x1 : x0) + of_row);
        }
        const int here = std::min(lanes, range.right - first + 1);
        for (std::uint32_t set = lane_set(least >= Row(0.0)) & ((1u << here) - 1); set; set &= set - 1)
          body(first + std::countr_zero(set), row);
      }
    }
  }

  /// The same for a triangle with a corner off the lattice, of the whole grid and in any order: whole blocks of tiles
  /// are ruled out together.
  template <class Body>
  void for_each(const ProjectiveTriangle& triangle, Body&& body) const {
    for_each(triangle, {0, 0, grid_.columns() - 1, grid_.rows() - 1}, body);
  }

private:
  template <class Body>
  void for_each(const ProjectiveTriangle& triangle, const Range& range, Body&& body) const {
    const auto index = [this](int column, int row) {
      return static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns()) +
             static_cast<std::size_t>(column);
    };
    const PixelRect first = grid_.tile(index(range.left, range.top)),
                    last = grid_.tile(index(range.right, range.bottom));
    if (!touches(triangle, {first.x, first.y, last.x + last.width - first.x, last.y + last.height - first.y})) return;
    const int wider = range.right - range.left, higher = range.bottom - range.top;
    if (wider == 0 && higher == 0) return body(range.left, range.top);
    Range low = range, high = range;
    if (wider > higher) low.right = range.left + wider / 2, high.left = low.right + 1;
    else low.bottom = range.top + higher / 2, high.top = low.bottom + 1;
    for_each(triangle, low, body);
    for_each(triangle, high, body);
  }

  TileGrid grid_;
};

} // namespace refraster
