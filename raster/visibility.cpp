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
  const Ints chosen = __builtin_convertvector(m.m, Ints) ? value - Ints{} : old;
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
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const TriangleRef ref = triangle_ref(scene, geometry, triangles[i]);
    const std::array<WindowVertex, 3> v = window_corners(geometry, ref);
    const auto place = static_cast<std::int32_t>(i);
    if ((v[0].outcode | v[1].outcode | v[2].outcode) & outcode::unsnapped)
      draw(bins.projective_triangle(triangles[i]), place);
    else draw(*set_up_snapped(v), place); // has area: bin_triangles dropped those that have not
  }
}

void TileVisibility::draw(const SnappedTriangle& triangle, std::int32_t place) {
  // All values below are integers under 2^53, or sums of two of them: exact in double. See subpixel.h.
  struct Edge {
    double a, b, c, least; // covered where the value is > least: 0, or -1/2 if the edge owns its ties
  };
  std::array<Edge, 3> edge;
  for (std::size_t k = 0; k < 3; ++k) {
    const SnappedLine& line = triangle.line[k];
    edge[k] = {static_cast<double>(line.a), static_cast<double>(line.b), static_cast<double>(line.c),
               line.owns_ties() ? -0.5 : 0.0};
  }
  const bool cut_by_near_plane = triangle.z_min < -1;

  for (std::size_t s = 0; s < samples_.size(); ++s) {
    const SamplePlace sample = samples_[s];
    // Pixels p of the tile with bounding box min <= 256 p + sample <= max.
    const auto first = [](std::int32_t min, std::int32_t offset, int begin) {
      return std::max((min - offset + subpixels - 1) >> 8, begin);
    };
    const auto last = [](std::int32_t max, std::int32_t offset, int end) {
      return std::min((max - offset) >> 8, end - 1);
    };
    const int x_first = first(triangle.x_min, sample.x, tile_.x) - tile_.x;
    const int x_last = last(triangle.x_max, sample.x, tile_.x + tile_.width) - tile_.x;
    const int y_first = first(triangle.y_min, sample.y, tile_.y) - tile_.y;
    const int y_last = last(triangle.y_max, sample.y, tile_.y + tile_.height) - tile_.y;

    for (int y = y_first; y <= y_last; ++y) {
      const double y_sample = (tile_.y + y) * subpixels + sample.y;
      const Row row0(edge[0].b * y_sample + edge[0].c), row1(edge[1].b * y_sample + edge[1].c),
          row2(edge[2].b * y_sample + edge[2].c);
      for (int x = x_first / lanes * lanes; x <= x_last; x += lanes) {
        const Row x_sample =
            lane_numbers() * Row(subpixels) + Row(static_cast<double>((tile_.x + x) * subpixels + sample.x));
        const Row e0 = Row(edge[0].a) * x_sample + row0;
        const Row e1 = Row(edge[1].a) * x_sample + row1;
        const Row e2 = Row(edge[2].a) * x_sample + row2;
        auto seen = (e0 > Row(edge[0].least)) & (e1 > Row(edge[1].least)) & (e2 > Row(edge[2].least));
        // The same operations as SnappedTriangle::depth.
        Row z = Row(triangle.z0) + e1 * Row(triangle.slope1) + e2 * Row(triangle.slope2);
        z = minimum(maximum(z, Row(triangle.z_min)), Row(triangle.z_max));
        const std::size_t at = index(static_cast<int>(s), x, y);
        const Row old = load(&depth_[at]);
        seen = seen & (z < old);
        if (cut_by_near_plane) seen = seen & (z >= Row(-1.0));
        store(&depth_[at], select(seen, z, old));
        store_where(&nearest_[at], seen, place);
      }
    }
  }
}

void TileVisibility::draw(const ProjectiveTriangle& triangle, std::int32_t place) {
  for (std::size_t s = 0; s < samples_.size(); ++s)
    for (int y = 0; y < tile_.height; ++y)
      for (int x = 0; x < tile_.width; ++x) {
        const std::int32_t x_sample = (tile_.x + x) * subpixels + samples_[s].x;
        const std::int32_t y_sample = (tile_.y + y) * subpixels + samples_[s].y;
        if (!(triangle.line[0].covers(x_sample, y_sample) && triangle.line[1].covers(x_sample, y_sample) &&
              triangle.line[2].covers(x_sample, y_sample)))
          continue;
        const double z = triangle.depth(x_sample, y_sample);
        const std::size_t at = index(static_cast<int>(s), x, y);
        if (z >= -1 && z < depth_[at]) {
          depth_[at] = z;
          nearest_[at] = place;
        }
      }
}

} // namespace refraster
