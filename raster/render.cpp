#include "raster/render.h"

#include "math/rungs.h"
#include "raster/shade.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <chrono>

#include <omp.h>

namespace refraster {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

void add(FrameCounts& sum, const FrameCounts& part) {
  sum.shaded += part.shaded;
  sum.fragments += part.fragments;
  sum.lane_slots += part.lane_slots;
  sum.undefined += part.undefined;
}

void add(TileSeconds& sum, const TileSeconds& part) {
  sum.visibility += part.visibility;
  sum.surfaces += part.surfaces;
  sum.shading += part.shading;
  sum.resolve += part.resolve;
}

bool cancelled(const RenderOptions& options) {
  return options.cancel && options.cancel->load(std::memory_order_relaxed);
}

// The last stage: visibility, then shading, tile by tile. Tiles write disjoint pixels, and counts are sums of integers,
// so which thread takes which tile changes nothing.
void shade_tiles(const FrameContext& context, const TileGrid& grid, std::span<const SamplePlace> samples, int threads,
                 Frame& frame) {
  const auto tiles = static_cast<std::ptrdiff_t>(grid.tiles());
  std::vector<FrameCounts> counts(static_cast<std::size_t>(threads));
  std::vector<TileSeconds> seconds(static_cast<std::size_t>(threads));
  std::atomic<std::ptrdiff_t> done{0};
#pragma omp parallel num_threads(threads)
  {
    const auto thread = static_cast<std::size_t>(omp_get_thread_num());
    TileVisibility visibility(grid.tile_size);
    const std::unique_ptr<TileShader> shader = make_tile_shader(context.options.rung);
#pragma omp for schedule(dynamic)
    for (std::ptrdiff_t i = 0; i < tiles; ++i) {
      if (cancelled(context.options)) continue;
      const auto index = static_cast<std::size_t>(i);
      const Crop tile = grid.tile(index);
      const std::span<const std::uint32_t> triangles = context.bins.of(index);
      const auto start = Clock::now();
      visibility.decide(context.scene, context.geometry, context.bins, triangles, tile, samples);
      seconds[thread].visibility += seconds_since(start);
      shader->shade(context, {tile, triangles, visibility}, frame, {counts[thread], seconds[thread]});
      const std::ptrdiff_t now_done = ++done;
      if (thread == 0 && context.options.progress)
        context.options.progress(static_cast<double>(now_done) / static_cast<double>(tiles));
    }
  }
  for (const FrameCounts& part : counts) add(frame.counts, part);
  for (const TileSeconds& part : seconds) add(frame.tile_seconds, part);
}

} // namespace

std::unique_ptr<TileShader> make_tile_shader(std::string_view rung) {
  if (rung == DoubleRung::name) return make_double_shader();
  if (rung == FloatRung::name) return make_float_shader();
  return nullptr;
}

Frame render(const Scene& scene, const RenderOptions& options) {
  assert(options.width >= 1 && options.width <= max_image_side && options.height >= 1 &&
         options.height <= max_image_side);
  assert(options.tile_size >= 8 && options.tile_size <= 128);
  assert(is_sample_count(options.samples) && options.crop.size() <= 1);
  const auto start = Clock::now();
  Frame frame;
  frame.threads = options.threads > 0 ? options.threads : omp_get_num_procs();

  const Crop region = options.crop.empty() ? Crop{0, 0, options.width, options.height} : options.crop.front();
  assert(region.x >= 0 && region.y >= 0 && region.width >= 1 && region.height >= 1 &&
         region.x + region.width <= options.width && region.y + region.height <= options.height);
  if (options.want_levels) frame.levels = Image<std::uint8_t>(region.width, region.height, 3);
  if (options.want_radiance) frame.radiance = Image<float>(region.width, region.height, 3);
  if (options.want_radiance_double) frame.radiance_double = Image<double>(region.width, region.height, 3);
  for (const Aov aov : options.aovs)
    frame.aovs.emplace_back(region.width, region.height, aov_channels[static_cast<std::size_t>(aov)]);
  frame.counts.pixels = static_cast<std::uint64_t>(region.width) * static_cast<std::uint64_t>(region.height);

  const std::span<const SamplePlace> samples = sample_pattern(options.samples);
  const TileGrid grid{region.x, region.y, region.width, region.height, options.tile_size};

  const auto transform_start = Clock::now();
  const Geometry geometry = transform(scene, options.width, options.height, frame.threads);
  frame.seconds.transform = seconds_since(transform_start);

  const auto bin_start = Clock::now();
  const Bins bins =
      bin_triangles(scene, geometry, grid, options.width, options.height, samples, frame.threads, frame.counts);
  frame.seconds.bin = seconds_since(bin_start);

  const auto tiles_start = Clock::now();
  shade_tiles({scene, geometry, bins, options, region}, grid, samples, frame.threads, frame);
  frame.seconds.tiles = seconds_since(tiles_start);
  frame.seconds.total = seconds_since(start);
  frame.cancelled = cancelled(options);
  return frame;
}

} // namespace refraster
