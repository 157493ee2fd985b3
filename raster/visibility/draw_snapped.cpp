#include "raster/visibility/draw_snapped.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace refraster {

namespace {

constexpr int lanes = SnappedRasterizer::lanes;
using Row = DepthTile::Row;
using Ints = VectorOf<std::int32_t, lanes>;

double sum(const Row& x, std::size_t count) {
  double result = 0;
  for (std::size_t lane = 0; lane < count; ++lane) result += x[static_cast<int>(lane)];
  return result;
}

// A triangle's edge functions and depth along a row, a register of samples wide, step by step to the right. Values are
// integers under 2^53, exact in double however they are added up: see subpixel.h.
struct RowWalk {
  std::array<Row, 3> e, step, threshold;
  DepthPlane<Row> depth;

  // Draws the register, and goes on to the next.
  template <class Clip>
  void draw(const DepthTile::Samples& samples, std::int32_t slot, const Clip& clip) {
    const Row z = depth.at(e[1], e[2]);
    const auto covered = (e[0] > threshold[0]) & (e[1] > threshold[1]) & (e[2] > threshold[2]);
    samples.depth_test_and_write(z, clip(covered, z), slot);
    for (std::size_t k = 0; k < 3; ++k) e[k] += step[k];
  }
};

} // namespace

[[gnu::flatten]] double SnappedRasterizer::draw(std::span<const PlacedTriangle> triangles, const PlacedVertex* vertices,
                                                const PixelRect& tile, std::span<const SamplePosition> samples,
                                                DepthTile& depths) {
  const std::size_t count = triangles.size();
  const auto corner = [&](std::size_t k) { return corners_of(triangles, vertices, k); };
  const CornerLanes<lanes> v0 = corner(0), v1 = corner(1), v2 = corner(2);
  const SnappedSetup<Row, 1> t = set_up_snapped(v0, v1, v2);
  const DepthPlane<Row> depth = depth_plane(t);
  const std::array<Row, 3> threshold = t.thresholds();
  for (std::size_t lane = 0; lane < count; ++lane) ready_.slot[lane] = triangles[lane].slot;
  const Row pixel(double{subpixels});
  const std::array<Row, 3> right_step{t.a[0] * pixel, t.a[1] * pixel, t.a[2] * pixel};
  const std::array<Row, 3> down_step{t.b[0] * pixel, t.b[1] * pixel, t.b[2] * pixel};
  for (std::size_t k = 0; k < 3; ++k) {
    store_lanes(ready_.right_step[k].data(), right_step[k]);
    store_lanes(ready_.down_step[k].data(), down_step[k]);
    store_lanes(ready_.threshold[k].data(), threshold[k]);
  }
  store_lanes(ready_.z0.data(), depth.z0);
  store_lanes(ready_.slope1.data(), depth.slope1), store_lanes(ready_.slope2.data(), depth.slope2);
  store_lanes(ready_.z_min.data(), depth.z_min), store_lanes(ready_.z_max.data(), depth.z_max);

  const SubpixelBoxes boxes(v0, v1, v2);
  double area = 0;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const SamplePosition sample = samples[s];
    const auto [left, top, right, bottom] = boxes.pixels(tile, sample);
    const auto subpixel = [](const Ints& p, int begin, int offset) {
      return numbers<lanes>((p + begin) * subpixels + offset);
    };
    const Row dx = subpixel(left, tile.x, sample.x) - t.corner[0].x,
              dy = subpixel(top, tile.y, sample.y) - t.corner[0].y;
    const Row e1 = t.a[1] * dx + t.b[1] * dy, e2 = t.a[2] * dx + t.b[2] * dy;
    const std::array<Row, 3> start{t.size - e1 - e2, e1, e2};
    for (std::size_t k = 0; k < 3; ++k) store_lanes(ready_.start[k].data(), start[k]);
    store_lanes(ready_.left.data(), left), store_lanes(ready_.right.data(), right), store_lanes(ready_.top.data(), top),
        store_lanes(ready_.bottom.data(), bottom);
    const SpanEdges<lanes> edges = span_edges<lanes>(start, right_step, down_step);
    for (std::size_t i = 0; i < 2; ++i) {
      store_lanes(ready_.edge[i].data(), edges.left[i].edge), store_lanes(ready_.slope[i].data(), edges.left[i].slope);
      store_lanes(ready_.edge[2 + i].data(), edges.right[i].edge),
          store_lanes(ready_.slope[2 + i].data(), edges.right[i].slope);
    }
    if (s == 0) {
      // The triangle's area, if it lies in the tile; up to the whole of the tile, the less of its box lies there.
      const Row pixels(1.0 / (subpixels * subpixels));
      const Row box = numbers<lanes>(boxes.x_max - boxes.x_min) * numbers<lanes>(boxes.y_max - boxes.y_min) * pixels;
      const Row in_tile = numbers<lanes>(right - left + 1) * numbers<lanes>(bottom - top + 1);
      const Row fraction = min(in_tile / box, Row(1.0));
      const Row covered = t.size * pixels * Row(0.5) * fraction * (Row(2.0) - fraction);
      area = sum(max(min(covered, in_tile), Row(0.0)), count);
    }
    for (std::size_t lane = 0; lane < count; ++lane)
      if (ready_.left[lane] <= ready_.right[lane]) draw_one(lane, static_cast<int>(s), depths);
  }
  return area;
}

void SnappedRasterizer::draw_one(std::size_t lane, int s, DepthTile& depths) {
  RowWalk walk;
  std::array<Row, 3> in_register;
  for (std::size_t k = 0; k < 3; ++k) {
    in_register[k] = lane_numbers<double, lanes>() * Row(ready_.right_step[k][lane]);
    walk.step[k] = Row(ready_.right_step[k][lane] * lanes);
    walk.threshold[k] = Row(ready_.threshold[k][lane]);
  }
  walk.depth = {Row(ready_.z0[lane]), Row(ready_.slope1[lane]), Row(ready_.slope2[lane]), Row(ready_.z_min[lane]),
                Row(ready_.z_max[lane])};
  const std::int32_t slot = ready_.slot[lane];
  const int left = ready_.left[lane], top = ready_.top[lane];
  const int width = ready_.right[lane] - left + 1, rows = ready_.bottom[lane] - top + 1;

  const auto row_of = [&](int row) { return depths.samples(depths.at(s, left, top + row)); };
  const auto draw_rows = [&](const auto& clip) {
    if (width <= lanes) {
      for (std::size_t k = 0; k < 3; ++k) {
        walk.e[k] = Row(ready_.start[k][lane]) + in_register[k];
        walk.step[k] = Row(ready_.down_step[k][lane]);
      }
      for (int row = 0; row < rows; ++row) walk.draw(row_of(row), slot, clip);
      return;
    }
    const auto of_lane = [lane](const std::array<Each<double>, 3>& values) {
      return std::array<double, 3>{values[0][lane], values[1][lane], values[2][lane]};
    };
    const auto edge = [&](std::size_t i) { return SpanBounds::Edge{ready_.edge[i][lane], ready_.slope[i][lane]}; };
    spans_.find<lanes>({{edge(0), edge(1)}, {edge(2), edge(3)}}, rows, width, of_lane(ready_.start),
                       of_lane(ready_.right_step), of_lane(ready_.down_step));
    const auto begin_at = [&](int row) {
      for (std::size_t k = 0; k < 3; ++k) walk.e[k] = Row(spans_.value(k, row)) + in_register[k];
    };
    if (width > 3 * lanes) {
      for (int row = 0; row < rows; ++row) {
        begin_at(row);
        const DepthTile::Samples samples = row_of(row);
        const int last = spans_.last(row);
        for (int x = spans_.first(row); x <= last; x += lanes) walk.draw(samples + x, slot, clip);
      }
      return;
    }
    // Whether a row needs a second step differs from row to row as if at random, and a branch for it would be guessed
    // wrongly half of the time: first every row has one step, and then those have more that need it.
    std::array<std::uint8_t, RowSpans::max_rows> long_row;
    std::size_t long_rows = 0;
    for (int row = 0; row < rows; ++row) {
      const int x = spans_.first(row);
      begin_at(row);
      walk.draw(row_of(row) + x, slot, clip);
      long_row[long_rows] = static_cast<std::uint8_t>(row);
      long_rows += x + lanes <= spans_.last(row);
    }
    for (std::size_t i = 0; i < long_rows; ++i) {
      const int row = long_row[i], last = spans_.last(row);
      const DepthTile::Samples samples = row_of(row);
      begin_at(row);
      for (std::size_t k = 0; k < 3; ++k) walk.e[k] += walk.step[k];
      for (int x = spans_.first(row) + lanes; x <= last; x += lanes) walk.draw(samples + x, slot, clip);
    }
  };
  if (ready_.z_min[lane] < -1) // cut by the near plane
    draw_rows([](auto covered, const Row& z) { return covered & (z >= Row(-1.0)); });
  else draw_rows([](auto covered, const Row&) { return covered; });
}

} // namespace refraster
