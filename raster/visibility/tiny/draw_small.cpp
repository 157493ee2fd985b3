#include "raster/visibility/tiny/draw_small.h"

#include "raster/visibility/tiny/small_triangles.h"

#include <algorithm>
#include <bit>

namespace refraster {

namespace {

constexpr int lanes = SmallTriangles::lanes;
using Row = DepthTile::Row;
using Ints = VectorOf<std::int32_t, lanes>;

int max_lane(const Ints& x) {
  const auto each = std::bit_cast<std::array<std::int32_t, lanes>>(x);
  return *std::max_element(each.begin(), each.end());
}

} // namespace

// Writes what is covered, and empties the list.
inline int SmallTriangles::write(Hits& hits, DepthTile& depths) const {
  const int covered = std::popcount(hits.set);
  for (; hits.set != 0; hits.set &= hits.set - 1) {
    const auto bit = static_cast<std::size_t>(std::countr_zero(hits.set));
    depths.depth_test_and_write_unguessed(static_cast<std::size_t>(hits.sample[bit]), hits.z[bit],
                                          triangle_[bit % lanes].slot);
  }
  hits.used = 0;
  return covered;
}

[[gnu::flatten]] double SmallTriangles::draw(const PlacedVertex* vertices, const PixelRect& tile,
                                             std::span<const SamplePosition> samples, DepthTile& depths) {
  const std::span<const PlacedTriangle> triangles(triangle_.data(), count_);
  const auto corner = [&](std::size_t k) { return corners_of(triangles, vertices, k); };
  const CornerLanes<lanes> v0 = corner(0), v1 = corner(1), v2 = corner(2);
  const SnappedSetup<Row, 1> t = set_up_snapped(v0, v1, v2);
  const SampleTest<lanes> test(t);
  const SubpixelBoxes boxes(v0, v1, v2);
  const Row pixel(double{subpixels});
  const Row right1 = t.a[1] * pixel, right2 = t.a[2] * pixel, down1 = t.b[1] * pixel, down2 = t.b[2] * pixel;
  const std::uint32_t in_use = (1u << count_) - 1;
  const auto row_step = static_cast<std::int32_t>(depths.at(0, 0, 1));
  int covered = 0;
  Hits hits;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const auto [left, top, right, bottom] = boxes.pixels(tile, samples[s]);
    const Ints width = right - left, height = bottom - top; // less 1
    const int last_column = max_lane(width), last_row = max_lane(height);
    const Row dx = numbers<lanes>((left + tile.x) * subpixels + samples[s].x) - t.corner[0].x;
    const Row dy = numbers<lanes>((top + tile.y) * subpixels + samples[s].y) - t.corner[0].y;
    const Ints first = top * row_step + left + static_cast<std::int32_t>(depths.at(static_cast<int>(s), 0, 0));
    Row row1 = t.a[1] * dx + t.b[1] * dy, row2 = t.a[2] * dx + t.b[2] * dy;
    for (int y = 0; y <= last_row; ++y, row1 += down1, row2 += down2) {
      const std::uint32_t in_row = in_use & negative_lanes(height >= y);
      Row e1 = row1, e2 = row2;
      for (int x = 0; x <= last_column; ++x, e1 += right1, e2 += right2) {
        Row z;
        const std::uint64_t set = test.covering(e1, e2, z) & in_row & negative_lanes(width >= x);
        store_lanes(&hits.z[hits.used * lanes], z);
        store_lanes(&hits.sample[hits.used * lanes], first + (y * row_step + x));
        hits.set |= set << (hits.used * lanes);
        if (++hits.used == Hits::places) covered += write(hits, depths);
      }
    }
  }
  covered += write(hits, depths);
  count_ = 0;
  return covered / static_cast<double>(samples.size());
}

} // namespace refraster
