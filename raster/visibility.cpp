#include "raster/visibility.h"

#include "raster/depth_range.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace refraster {

namespace {

using Row = Native<double>;
constexpr int lanes = NumberTraits<Row>::lanes;
using Ints = VectorOf<std::int32_t, lanes>;

Row load(const double* at) {
  Row x;
  std::memcpy(&x.v, at, sizeof x.v);
  return x;
}
void store(double* at, Row x) {
  std::memcpy(at, &x.v, sizeof x.v);
}
Ints load(const std::int32_t* at) {
  Ints x;
  std::memcpy(&x, at, sizeof x);
  return x;
}
void store_where(std::int32_t* at, MaskOf<Row> m, std::int32_t value) {
  const Ints chosen = __builtin_convertvector(lane_bits(m), Ints) ? value - Ints{} : load(at);
  std::memcpy(at, &chosen, sizeof chosen);
}

Row lane_numbers() {
  Row x;
  for (int lane = 0; lane < lanes; ++lane) x.set(lane, lane);
  return x;
}

} // namespace

TileVisibility::TileVisibility(int tile_size)
    : rows_(static_cast<std::size_t>(tile_size)), stride_(static_cast<std::size_t>(tile_size + lanes)) {}

// Triangles come in submission order, each perhaps several times in a row.
std::int32_t TileVisibility::place_of(std::uint32_t triangle) {
  if (triangles_.empty() || triangles_.back() != triangle) triangles_.push_back(triangle);
  return static_cast<std::int32_t>(triangles_.size() - 1);
}

void TileVisibility::decide(const Scene& scene, const Geometry& geometry, const Bins& bins, std::size_t index,
                            const Crop& tile, std::span<const SamplePlace> samples) {
  tile_ = tile;
  samples_ = samples;
  depth_.assign(samples.size() * rows_ * stride_, beyond_far);
  nearest_.assign(samples.size() * rows_ * stride_, nothing);
  triangles_.clear();
  boxed_.clear();
  bins.lists.for_each_piece(index, [&](std::span<const TileEntry> entries) {
    for (const TileEntry& entry : entries) {
      switch (entry.kind()) {
      case TileEntry::Kind::sample: {
        const std::size_t sample = at(entry.s(), entry.x(), entry.y());
        if (entry.z < depth_[sample]) { // of samples alone the first submitted comes first
          depth_[sample] = entry.z;
          nearest_[sample] = place_of(entry.triangle);
        }
        break;
      }
      case TileEntry::Kind::box:
        boxed_.push_back({entry.triangle, place_of(entry.triangle), entry.z});
        break;
      case TileEntry::Kind::projective:
        draw(bins.projective_triangle(entry.triangle), place_of(entry.triangle));
        break;
      }
    }
  });
  const std::span<const Boxed> boxed = boxed_;
  for (std::size_t i = 0; i < boxed.size(); i += lanes)
    draw(boxed.subspan(i, std::min<std::size_t>(boxed.size() - i, lanes)), scene, geometry);
}

// Whatever order triangles are drawn in, of equal depths the first submitted is seen.
void TileVisibility::see(std::size_t sample, double z, std::int32_t place) {
  if (z < depth_[sample] || (z == depth_[sample] && place < nearest_[sample])) {
    depth_[sample] = z;
    nearest_[sample] = place;
  }
}

// Triangles that are drawn together, ready for one sample of each pixel. Numbers that are read triangle by triangle.
struct TileVisibility::Drawn {
  std::array<std::int32_t, lanes> place, left, top, right, bottom;              // pixels of the tile
  std::array<std::array<double, lanes>, 3> start, right_step, down_step, least; // of the three lines
  std::array<double, lanes> z0, slope1, slope2, z_min, z_max;
};

void TileVisibility::draw(std::span<const Boxed> boxed, const Scene& scene, const Geometry& geometry) {
  std::array<TriangleRef, lanes> ref;
  for (std::size_t lane = 0; lane < lanes; ++lane)
    ref[lane] = triangle_ref(scene, geometry, boxed[std::min(lane, boxed.size() - 1)].triangle);
  const auto corner = [&](std::size_t k) {
    return gather_corners<lanes>([&](int lane) -> const PlacedVertex& {
      return geometry.window.placed[ref[static_cast<std::size_t>(lane)].vertex[k]];
    });
  };
  const CornerLanes<lanes> v0 = corner(0), v1 = corner(1), v2 = corner(2);
  const SnappedLanes<lanes> t = set_up_lanes(v0, v1, v2);

  Drawn drawn;
  for (std::size_t lane = 0; lane < boxed.size(); ++lane) drawn.place[lane] = boxed[lane].place;
  const auto set = [](std::array<double, lanes>& at, const Row& x) { store(at.data(), x); };
  const Row pixel(double{subpixels});
  const std::array<Row, 3> a{t.a0() * pixel, t.a1 * pixel, t.a2 * pixel};
  const std::array<Row, 3> b{t.b0() * pixel, t.b1 * pixel, t.b2 * pixel};
  for (std::size_t k = 0; k < 3; ++k) {
    set(drawn.right_step[k], a[k]);
    set(drawn.down_step[k], b[k]);
    set(drawn.least[k], t.least[k]);
  }
  set(drawn.z0, t.z0), set(drawn.slope1, t.slope1), set(drawn.slope2, t.slope2);
  set(drawn.z_min, t.z_min), set(drawn.z_max, t.z_max);

  const auto least = [](const Ints& x, const Ints& y) { return x < y ? x : y; };
  const auto greatest = [](const Ints& x, const Ints& y) { return x > y ? x : y; };
  const Ints x_min = least(v0.x_subpixel, least(v1.x_subpixel, v2.x_subpixel));
  const Ints y_min = least(v0.y_subpixel, least(v1.y_subpixel, v2.y_subpixel));
  const Ints x_max = greatest(v0.x_subpixel, greatest(v1.x_subpixel, v2.x_subpixel));
  const Ints y_max = greatest(v0.y_subpixel, greatest(v1.y_subpixel, v2.y_subpixel));
  for (std::size_t s = 0; s < samples_.size(); ++s) {
    const SamplePlace sample = samples_[s];
    // Pixels p of the tile with bounding box min <= 256 p + sample <= max.
    const auto first = [&](const Ints& min, int offset, int begin) {
      return greatest(((min - offset + (subpixels - 1)) >> 8) - begin, Ints{});
    };
    const auto last = [&](const Ints& max, int offset, int begin, int size) {
      return least(((max - offset) >> 8) - begin, size - 1 - Ints{});
    };
    const Ints left = first(x_min, sample.x, tile_.x), right = last(x_max, sample.x, tile_.x, tile_.width);
    const Ints top = first(y_min, sample.y, tile_.y), bottom = last(y_max, sample.y, tile_.y, tile_.height);
    drawn.left = std::bit_cast<std::array<std::int32_t, lanes>>(left);
    drawn.right = std::bit_cast<std::array<std::int32_t, lanes>>(right);
    drawn.top = std::bit_cast<std::array<std::int32_t, lanes>>(top);
    drawn.bottom = std::bit_cast<std::array<std::int32_t, lanes>>(bottom);
    const auto subpixel = [](const Ints& p, int begin, int offset) {
      return Row(__builtin_convertvector((p + begin) * subpixels + offset, VectorOf<double, lanes>));
    };
    const Row dx = subpixel(left, tile_.x, sample.x) - t.x0, dy = subpixel(top, tile_.y, sample.y) - t.y0;
    const Row e1 = t.a1 * dx + t.b1 * dy, e2 = t.a2 * dx + t.b2 * dy;
    set(drawn.start[0], t.size - e1 - e2), set(drawn.start[1], e1), set(drawn.start[2], e2);
    for (std::size_t lane = 0; lane < boxed.size(); ++lane)
      if (drawn.left[lane] <= drawn.right[lane]) draw(drawn, lane, static_cast<int>(s));
  }
}

void TileVisibility::draw(const Drawn& triangle, std::size_t lane, int s) {
  // Line values and their steps are integers under 2^53: exact in double, however they are added up. See subpixel.h.
  std::array<Row, 3> row_start, down, step, least;
  for (std::size_t k = 0; k < 3; ++k) {
    const Row right(triangle.right_step[k][lane]);
    row_start[k] = Row(triangle.start[k][lane]) + lane_numbers() * right;
    step[k] = right * Row(double{lanes});
    down[k] = Row(triangle.down_step[k][lane]);
    least[k] = Row(triangle.least[k][lane]);
  }
  const Row z0(triangle.z0[lane]), slope1(triangle.slope1[lane]), slope2(triangle.slope2[lane]);
  const Row z_min(triangle.z_min[lane]), z_max(triangle.z_max[lane]);
  const std::int32_t place = triangle.place[lane];
  const int left = triangle.left[lane], right = triangle.right[lane], bottom = triangle.bottom[lane];
  const bool cut_by_near_plane = triangle.z_min[lane] < -1;
  for (int y = triangle.top[lane]; y <= bottom; ++y) {
    std::array<Row, 3> e = row_start;
    for (std::size_t k = 0; k < 3; ++k) row_start[k] += down[k];
    const std::size_t row = at(s, 0, y);
    for (int x = left; x <= right; x += lanes) {
      // The same operations as SnappedTriangle::depth.
      Row z = z0 + e[1] * slope1 + e[2] * slope2;
      z = minimum(maximum(z, z_min), z_max);
      auto covered = (e[0] > least[0]) & (e[1] > least[1]) & (e[2] > least[2]);
      if (cut_by_near_plane) covered = covered & (z >= Row(-1.0));
      double* const depth = &depth_[row + static_cast<std::size_t>(x)];
      std::int32_t* const nearest = &nearest_[row + static_cast<std::size_t>(x)];
      const Row old = load(depth);
      auto seen = covered & (z < old);
      const auto tie = covered & (z == old);
      if (any(tie)) [[unlikely]] {
        const Row old_place = __builtin_convertvector(load(nearest), VectorOf<double, lanes>);
        seen = seen | (tie & (Row(static_cast<double>(place)) < old_place));
      }
      store(depth, select(seen, z, old));
      store_where(nearest, seen, place);
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
        if (z >= -1) see(at(static_cast<int>(s), x, y), z, place);
      }
}

} // namespace refraster
