#include "raster/visibility/visibility.h"

#include "raster/visibility/depth_range.h"
#include "raster/visibility/draw_projective.h"

#include <algorithm>
#include <array>

namespace refraster {

void TileVisibility::decide(const FrameContext& context, std::size_t index, const PixelRect& tile) {
  tile_ = tile;
  samples_ = context.samples;
  depths_.clear(tile, samples_.size());
  if (context.uses.cut_outs) [[unlikely]]
    decide_as<WithCutOuts::yes>(context, index);
  else decide_as<WithCutOuts::no>(context, index);
}

template <TileVisibility::WithCutOuts cut_outs>
void TileVisibility::decide_as(const FrameContext& context, std::size_t index) {
  if constexpr (cut_outs == WithCutOuts::yes) {
    if (!cut_outs_) cut_outs_ = make_cut_outs();
    cut_outs_->enter(context);
    alone_is_clear_ = false;
  }
  read<cut_outs>(context.bins, index);
  if (boxed_.size() > 1) sort_boxed();
  draw_boxed<cut_outs>(context);
}

// Draws what is simple, and notes what is not.
template <TileVisibility::WithCutOuts cut_outs>
void TileVisibility::read(const Bins& bins, std::size_t index) {
  triangles_.clear();
  boxed_.clear();
  bins.lists.for_each_piece(index, [&](std::span<const TileEntry> entries) {
    for (const TileEntry& entry : entries) {
      switch (entry.kind()) {
      case TileEntry::Kind::sample: {
        const std::size_t sample = depths_.at(entry.s(), entry.x(), entry.y());
        if (entry.z <= depths_.depth(sample) && (cut_outs == WithCutOuts::no || is_there(entry)))
          depths_.depth_test_and_write(sample, entry.z, slot_of(entry.triangle));
        break;
      }
      case TileEntry::Kind::box:
        if (entry.z < beyond_far) boxed_.push_back({entry, slot_of(entry.triangle)});
        break;
      case TileEntry::Kind::projective:
        if constexpr (cut_outs == WithCutOuts::yes)
          if (cut_outs_->has_cut_outs(entry.triangle)) {
            const std::int32_t slot = slot_of(entry.triangle);
            draw_projective(bins.projective_triangle(entry.triangle), slot, tile_, samples_, alone());
            add_what_is_there({0, 0, tile_.width, tile_.height}, slot);
            break;
          }
        draw_projective(bins.projective_triangle(entry.triangle), slot_of(entry.triangle), tile_, samples_, depths_);
        break;
      }
    }
  });
}

bool TileVisibility::is_there(const TileEntry& sample) {
  if (!cut_outs_->has_cut_outs(sample.triangle)) return true;
  return (lane_set(cut_outs_->is_there(tile_.x + sample.x(), tile_.y + sample.y(), 1)) & 1) != 0;
}

// The samples of one triangle alone: empty.
DepthTile& TileVisibility::alone() {
  if (!alone_) alone_ = std::make_unique<DepthTile>(depths_);
  if (!alone_is_clear_) alone_->clear(tile_, samples_.size());
  alone_is_clear_ = true;
  return *alone_;
}

// Moves what was drawn alone, in these pixels of the tile, to the others, but for what is cut out. Opacity is asked for
// once a pixel, and only where it matters.
void TileVisibility::add_what_is_there(const PixelRect& pixels, std::int32_t slot) {
  using Row = DepthTile::Row;
  constexpr int lanes = DepthTile::lanes;
  for (int y = pixels.y; y < pixels.y + pixels.height; ++y)
    for (int x = pixels.x; x < pixels.x + pixels.width; x += lanes) {
      const int here = std::min(lanes, pixels.x + pixels.width - x);
      const auto within = lane_numbers<double, lanes>() < Row(static_cast<double>(here));
      const auto for_each_sample = [&](auto&& body) {
        for (int s = 0; s < static_cast<int>(samples_.size()); ++s) {
          const std::size_t at = depths_.at(s, x, y);
          body(alone_->samples(at), depths_.samples(at));
        }
      };
      const auto may_be_seen = [&](const Row& z, const Row& nearest) {
        return within & (z <= nearest) & (z < Row(beyond_far));
      };
      bool any_seen = false;
      for_each_sample([&](const DepthTile::Samples& own, const DepthTile::Samples& all) {
        any_seen = any_seen || any(may_be_seen(load_lanes<Row>(own.depth), load_lanes<Row>(all.depth)));
      });
      const auto there = any_seen ? within & cut_outs_->is_there(tile_.x + x, tile_.y + y, here) : within;
      for_each_sample([&](const DepthTile::Samples& own, const DepthTile::Samples& all) {
        const Row z = load_lanes<Row>(own.depth);
        if (any_seen) all.depth_test_and_write(z, there & may_be_seen(z, load_lanes<Row>(all.depth)), slot);
        store_lanes(own.depth, Row(beyond_far)); // nobody reads the slots of what is drawn alone
      });
    }
}

// From front to back, more or less: the nearer triangles come first, the more of those behind need not be drawn at all.
void TileVisibility::sort_boxed() {
  constexpr std::size_t buckets = 32;
  const auto depth = [](const Boxed& boxed) { return min(max(boxed.entry.z, -1.0), 1.0); };
  double nearest = 1, farthest = -1;
  for (const Boxed& boxed : boxed_) {
    nearest = min(depth(boxed), nearest);
    farthest = max(depth(boxed), farthest);
  }
  if (!(farthest - nearest >= 0x1p-1000)) return; // the same depth; or so near it that the scale would be infinite
  const double scale = (buckets - 0.5) / (farthest - nearest);
  const auto bucket_of = [&](const Boxed& boxed) {
    return std::min(static_cast<std::size_t>((depth(boxed) - nearest) * scale), buckets - 1);
  };
  std::array<std::size_t, buckets> next{};
  for (const Boxed& boxed : boxed_) ++next[bucket_of(boxed)];
  std::size_t begin = 0;
  for (std::size_t& n : next) begin += std::exchange(n, begin);
  sorted_.resize(boxed_.size());
  for (const Boxed& boxed : boxed_) sorted_[next[bucket_of(boxed)]++] = boxed;
  boxed_.swap(sorted_);
}

template <TileVisibility::WithCutOuts cut_outs>
void TileVisibility::draw_boxed(const FrameContext& context) {
  std::array<PlacedTriangle, SnappedRasterizer::lanes> together;
  std::size_t count = 0;
  // Once as much has been drawn as covers the tile, it is worth while to look how deep it is everywhere: before large
  // triangles wait for each other.
  const double enough = 0.875 * tile_.width * tile_.height;
  double drawn = 0, waiting = 0; // pixels: covered, about; in the boxes of triangles that wait
  TriangleFinder finder(context.scene, context.geometry);
  const Geometry& geometry = context.geometry;
  const bool stored = geometry.all_stored();
  const PlacedVertex* const vertices = stored ? geometry.window.placed.data() : corners_.data();
  SmallTriangles waiting_small;
  const auto add_drawn = [&](double pixels) {
    drawn += pixels;
    if (drawn < enough) return;
    drawn = 0;
    depths_.refresh_bounds();
  };
  const auto draw_together = [&] {
    add_drawn(rasterizer_.draw({together.data(), count}, vertices, tile_, samples_, depths_));
    count = 0;
    waiting = 0;
  };
  constexpr std::size_t ahead = 16; // entries: sorted, they name triangles in an order that no cache foresees
  for (std::size_t i = 0; i < boxed_.size(); ++i) {
    if (i + ahead < boxed_.size()) finder.ask_for(boxed_[i + ahead].entry.triangle);
    const Boxed& boxed = boxed_[i];
    const TileEntry& entry = boxed.entry;
    if (depths_.is_occluded(entry.left(), entry.top(), entry.right(), entry.bottom(), entry.z)) continue;
    const TriangleRef ref = finder.at(entry.triangle);
    PlacedTriangle triangle{{ref.vertex[0], ref.vertex[1], ref.vertex[2]}, boxed.slot};
    const bool small = SmallTriangles::is_small(entry);
    if (!stored) [[unlikely]] { // then those that are drawn together are listed anew
      const std::array<WindowVertex, 3> corners = window_corners(geometry, ref);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t place = small ? corners_.size() / 2 + 3 * waiting_small.size() + k : 3 * count + k;
        corners_[place] = PlacedVertex::of(corners[k]);
        triangle.vertex[k] = static_cast<std::uint32_t>(place);
      }
    }
    if constexpr (cut_outs == WithCutOuts::yes)
      if (cut_outs_->has_cut_outs(entry.triangle)) {
        rasterizer_.draw({&triangle, 1}, vertices, tile_, samples_, alone());
        add_what_is_there(
            {entry.left(), entry.top(), entry.right() - entry.left() + 1, entry.bottom() - entry.top() + 1},
            boxed.slot);
        continue;
      }
    if (small) {
      if (stored)
        for (const std::uint32_t vertex : triangle.vertex) __builtin_prefetch(&vertices[vertex]);
      waiting_small.add(triangle);
      if (waiting_small.full()) add_drawn(waiting_small.draw(vertices, tile_, samples_, depths_));
      continue;
    }
    together[count++] = triangle;
    waiting += (entry.right() - entry.left() + 1) * (entry.bottom() - entry.top() + 1);
    if (count == together.size() || waiting >= enough) draw_together();
  }
  if (!waiting_small.empty()) waiting_small.draw(vertices, tile_, samples_, depths_);
  if (count > 0) draw_together();
}

} // namespace refraster
