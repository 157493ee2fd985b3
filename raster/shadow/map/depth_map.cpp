#include "raster/shadow/map/depth_map.h"

#include "raster/parallel.h"
#include "raster/visibility/visibility.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace refraster {
namespace {

/// The whole number below x, cut to what an int holds with room to spare; 0 for NaN. `size` is far below that.
int whole_below(double x, int size) {
  const double limit = 4.0 * size;
  return static_cast<int>(std::floor(x > -limit ? std::min(x, limit) : x <= -limit ? -limit : 0));
}

} // namespace

MapCell map_cell(ShadowFilter filter, double at, int size) {
  switch (filter) {
  case ShadowFilter::nearest:
    return {whole_below(at, size), 0};
  case ShadowFilter::two_by_two: {
    const double from_centre = at - 0.5;
    const int first = whole_below(from_centre, size);
    const double fraction = from_centre - first;
    return {first, fraction >= 0 && fraction < 1 ? fraction : 0}; // else far outside
  }
  case ShadowFilter::pcf3:
    return {whole_below(at, size) - 1, 0};
  }
  return {};
}

void DepthMap::draw(const FrameInput& frame, const Scene& casters, const LightView& view, DepthMapScratch& scratch) {
  view_ = view;
  const int size = view.map.size;
  const auto pixels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  texels_.resize_uninitialized(view.faces() * pixels);
  RenderOptions options;
  options.width = options.height = size;
  options.tile_size = frame.options.tile_size;
  options.threads = frame.threads;
  options.memory = frame.options.memory;
  std::vector<TileVisibility> workers;
  for (int i = 0; i < frame.threads; ++i) workers.emplace_back(options.tile_size);
  for (std::size_t face = 0; face < view.faces(); ++face) {
    FrameContext context{{casters, options}, scratch.geometry, scratch.bins};
    context.viewpoint = view.viewpoint(face);
    lay_out(context, scratch.geometry);
    transform_stored(context, scratch.geometry);
    FrameCounts uncounted; // of the image: the map's are no news
    bin_triangles(context, scratch.geometry, scratch.bins, uncounted);
    const TileGrid grid = tile_grid(context);
    float* const texels = texels_.data() + face * pixels;
    parallel_for(frame.threads, grid.tiles(), [&](std::size_t index, int thread) {
      TileVisibility& visibility = workers[static_cast<std::size_t>(thread)];
      const PixelRect tile = grid.tile(index);
      visibility.decide(context, index, tile);
      for (int y = 0; y < tile.height; ++y) {
        float* const row = texels + static_cast<std::size_t>(size - 1 - tile.y - y) * static_cast<std::size_t>(size);
        for (int x = 0; x < tile.width; ++x) // (z + 1) / 2 in double, rounded once
          row[tile.x + x] = static_cast<float>(std::min(visibility.depth(0, x, y) * 0.5 + 0.5, 1.0));
      }
    });
  }
}

MapTaps DepthMap::taps(std::size_t face, const MapPlace<double>& place) const {
  const ShadowFilter filter = view_.map.filter;
  const int size = view_.map.size, across = taps_across(filter);
  const MapCell u = map_cell(filter, place.u, size), v = map_cell(filter, place.v, size);
  const bool clamps = view_.kind == LightPlace::Kind::point;
  MapTaps taps;
  for (int j = 0; j < across; ++j)
    for (int i = 0; i < across; ++i) {
      MapTap& tap = taps.tap[static_cast<std::size_t>(taps.count++)];
      tap.column = u.first + i, tap.row = v.first + j;
      if (clamps) tap.column = std::clamp(tap.column, 0, size - 1), tap.row = std::clamp(tap.row, 0, size - 1);
      tap.outside = tap.column < 0 || tap.column >= size || tap.row < 0 || tap.row >= size;
      if (!tap.outside) tap.stored = at(face, tap.column, tap.row);
      tap.lit = tap.outside || !(place.depth > static_cast<double>(tap.stored));
      if (filter == ShadowFilter::two_by_two)
        tap.weight = (i ? u.fraction : 1 - u.fraction) * (j ? v.fraction : 1 - v.fraction);
      if (filter == ShadowFilter::pcf3) tap.weight = 1.0 / 9;
    }
  return taps;
}

double lit_fraction(const MapTaps& taps, ShadowFilter filter) {
  int lit = 0;
  double weights = 0;
  for (int i = 0; i < taps.count; ++i) {
    const MapTap& tap = taps.tap[static_cast<std::size_t>(i)];
    lit += tap.lit;
    if (tap.lit) weights += tap.weight;
  }
  if (lit == 0 || lit == taps.count) return lit == 0 ? 0 : 1; // whatever weights rounding leaves
  return filter == ShadowFilter::pcf3 ? lit / 9.0 : weights;
}

double DepthMap::visibility(const Double3& position, const Double3& normal) const {
  const std::size_t face = face_of(position);
  return lit_fraction(taps(face, map_place<double>(view_, face, position, normal)), view_.map.filter);
}

} // namespace refraster
