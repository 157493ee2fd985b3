#include "raster/visibility.h"

#include "math/rungs.h"

#include <algorithm>
#include <cstring>

namespace refraster {

namespace {

using Row = Native<double>; // as many neighbouring samples as a register holds
constexpr int lanes = NumberTraits<Row>::lanes;

// The least number above 1: a depth is drawn if it is LESS than this, that is, up to and including the far plane.
constexpr double beyond_far = 1 + std::numeric_limits<double>::epsilon();

Row load(const double* at) {
  Row x;
  std::memcpy(&x.v, at, sizeof x.v);
  return x;
}
void store(double* at, Row x) {
  std::memcpy(at, &x.v, sizeof x.v);
}
void store_where(std::int32_t* at, MaskOf<Row> m, std::int32_t value) {
  using Ints = VectorOf<std::int32_t, lanes>;
  Ints old;
  std::memcpy(&old, at, sizeof old);
  const Ints chosen = __builtin_convertvector(lane_bits(m), Ints) ? value - Ints{} : old;
  std::memcpy(at, &chosen, sizeof chosen);
}

Row lane_numbers() {
  Row x;
  for (int lane = 0; lane < lanes; ++lane) x.set(lane, lane);
  return x;
}

} // namespace

TileVisibility::TileVisibility(int tile_size)
    : rows_(static_cast<std::size_t>(tile_size)),
      stride_(static_cast<std::size_t>((tile_size + lanes - 1) / lanes * lanes)) {}

void TileVisibility::decide(const Scene& scene, const Geometry& geometry, const Bins& bins,
                            std::span<const std::uint32_t> triangles, const Crop& tile,
                            std::span<const SamplePlace> samples) {
  tile_ = tile;
  samples_ = samples;
  depth_.assign(samples.size() * rows_ * stride_, beyond_far);
  nearest_.assign(samples.size() * rows_ * stride_, nothing);
  TriangleCursor cursor(scene, geometry);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::array<WindowVertex, 3> v = window_corners(geometry, cursor.at(triangles[i]));
    const auto place = static_cast<std::int32_t>(i);
    if ((v[0].outcode | v[1].outcode | v[2].outcode) & outcode::unsnapped)
      draw(bins.projective_triangle(triangles[i]), place);
    else draw(*set_up_snapped(v), place); // has area: bin_triangles dropped those that have not
  }
}

void TileVisibility::draw(const SnappedTriangle& triangle, std::int32_t place) {
  for (std::size_t s = 0; s < samples_.size(); ++s) {
    const SamplePlace sample = samples_[s];
    // Pixels p of the tile with bounding box min <= 256 p + sample <= max.
    const auto first = [](std::int32_t min, std::int32_t offset, int begin) {
      return std::max((min - offset + subpixels - 1) >> 8, begin);
    };
    const auto last = [](std::int32_t max, std::int32_t offset, int end) {
      return std::min((max - offset) >> 8, end - 1);
    };
    const int x_first = (first(triangle.x_min, sample.x, tile_.x) - tile_.x) / lanes * lanes;
    const int x_last = last(triangle.x_max, sample.x, tile_.x + tile_.width) - tile_.x;
    const int y_first = first(triangle.y_min, sample.y, tile_.y) - tile_.y;
    const int y_last = last(triangle.y_max, sample.y, tile_.y + tile_.height) - tile_.y;
    if (x_first > x_last || y_first > y_last) continue;

    // A tile that lies inside all three lines needs no coverage test. Its samples are the corners of this rectangle and
    // those between; a line is least where its negative is most.
    const auto place_of = [](int pixel, std::int32_t offset) { return pixel * subpixels + offset; };
    const std::int32_t x0 = place_of(tile_.x + x_first, sample.x),
                       x1 = place_of(tile_.x + (x_last | (lanes - 1)), sample.x);
    const std::int32_t y0 = place_of(tile_.y + y_first, sample.y), y1 = place_of(tile_.y + y_last, sample.y);
    const bool inside = std::all_of(triangle.line.begin(), triangle.line.end(),
                                    [&](const SnappedLine& line) { return (-line).most(x0, y0, x1, y1) < 0; });
    const Span span{static_cast<int>(s), x_first, x_last, y_first, y_last, x0, y0};
    if (inside) draw_rows<Coverage::whole>(triangle, place, span);
    else draw_rows<Coverage::tested>(triangle, place, span);
  }
}

template <TileVisibility::Coverage coverage>
void TileVisibility::draw_rows(const SnappedTriangle& triangle, std::int32_t place, const Span& span) {
  // Line values and their steps are integers under 2^53: exact in double, however they are added up. See subpixel.h.
  std::array<double, 3> row_value, least, row_step;
  std::array<Row, 3> lane_offset, step;
  for (std::size_t k = 0; k < 3; ++k) {
    const SnappedLine& line = triangle.line[k];
    row_value[k] = static_cast<double>(line.at(span.x_sample, span.y_sample));
    row_step[k] = static_cast<double>(line.b * subpixels);
    lane_offset[k] = lane_numbers() * Row(static_cast<double>(line.a * subpixels));
    step[k] = Row(static_cast<double>(line.a * subpixels * lanes));
    least[k] = line.owns_ties() ? -0.5 : 0.0; // covered where the value is greater
  }
  const bool cut_by_near_plane = triangle.z_min < -1;
  for (int y = span.y_first; y <= span.y_last; ++y) {
    std::array<Row, 3> e;
    for (std::size_t k = 0; k < 3; ++k) {
      e[k] = Row(row_value[k]) + lane_offset[k];
      row_value[k] += row_step[k];
    }
    const std::size_t row = index(span.sample, 0, y);
    for (int x = span.x_first; x <= span.x_last; x += lanes) {
      // The same operations as SnappedTriangle::depth.
      Row z = Row(triangle.z0) + e[1] * Row(triangle.slope1) + e[2] * Row(triangle.slope2);
      z = minimum(maximum(z, Row(triangle.z_min)), Row(triangle.z_max));
      const std::size_t at = row + static_cast<std::size_t>(x);
      const Row old = load(&depth_[at]);
      auto seen = z < old;
      if constexpr (coverage == Coverage::tested)
        seen = seen & (e[0] > Row(least[0])) & (e[1] > Row(least[1])) & (e[2] > Row(least[2]));
      if (cut_by_near_plane) seen = seen & (z >= Row(-1.0));
      store(&depth_[at], select(seen, z, old));
      store_where(&nearest_[at], seen, place);
      for (std::size_t k = 0; k < 3; ++k) e[k] += step[k];
    }
  }
}

void TileVisibility::draw(const ProjectiveTriangle& triangle, std::int32_t place) {
  for (int piece = 0; piece < triangle.pieces; ++piece) draw(triangle.piece[static_cast<std::size_t>(piece)], place);
}

void TileVisibility::draw(const ProjectivePiece& piece, std::int32_t place) {
  for (std::size_t s = 0; s < samples_.size(); ++s)
    for (int y = 0; y < tile_.height; ++y)
      for (int x = 0; x < tile_.width; ++x) {
        const std::int32_t x_sample = (tile_.x + x) * subpixels + samples_[s].x;
        const std::int32_t y_sample = (tile_.y + y) * subpixels + samples_[s].y;
        if (!piece.covers(x_sample, y_sample)) continue;
        const double z = piece.depth(x_sample, y_sample);
        const std::size_t at = index(static_cast<int>(s), x, y);
        if (z >= -1 && z < depth_[at]) {
          depth_[at] = z;
          nearest_[at] = place;
        }
      }
}

} // namespace refraster
