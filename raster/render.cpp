#include <refraster/render.h>

#include "math/large_memory.h"
#include "math/precisions.h"
#include "raster/parallel.h"
#include "raster/shade/shade.h"
#include "raster/shadow/scene_shadows.h"
#include "raster/stopwatch.h"
#include "raster/tile_order.h"
#include "scene/scene_checks.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstring>
#include <stdexcept>
#include <string>

namespace refraster {

namespace {

bool cancelled(const RenderOptions& options) {
  return options.cancel && options.cancel->load(std::memory_order_relaxed);
}

// What one thread works with, tile after tile.
struct TileWorker {
  TileVisibility visibility;
  std::unique_ptr<TileShading> shading;
  FrameCounts counts;
  TileSeconds seconds;

  TileWorker(int tile_size, std::unique_ptr<TileShading> its_shading)
      : visibility(tile_size), shading(std::move(its_shading)) {}
};

// The last stage: visibility, then shading, tile by tile. Tiles write disjoint pixels, and counts are sums of integers,
// so which thread takes which tile changes nothing.
void shade_tiles(const FrameContext& context, std::span<TileWorker> workers, Frame& frame) {
  const TileGrid grid = tile_grid(context);
  const std::vector<std::uint32_t> order = tile_order(grid, context.bins.lists, static_cast<int>(workers.size()));
  std::atomic<std::size_t> done{0};
  parallel_for(static_cast<int>(workers.size()), grid.tiles(), [&](std::size_t turn, int thread) {
    if (cancelled(context.options)) return;
    const std::size_t index = order[turn];
    TileWorker& worker = workers[static_cast<std::size_t>(thread)];
    const PixelRect tile = grid.tile(index);
    const Stopwatch stopwatch;
    worker.visibility.decide(context, index, tile);
    worker.seconds.visibility += stopwatch.seconds();
    worker.shading->shade(context, {tile, worker.visibility.triangles(), worker.visibility}, frame,
                          {worker.counts, worker.seconds});
    const std::size_t now_done = ++done;
    if (thread == 0 && now_done < grid.tiles() && context.options.progress)
      context.options.progress(static_cast<double>(now_done) / static_cast<double>(grid.tiles()));
  });
  if (context.options.progress && !cancelled(context.options)) context.options.progress(1);
  for (const TileWorker& worker : workers) {
    frame.counts += worker.counts;
    frame.tile_seconds += worker.seconds;
  }
}

// Calls body(begin, end) for pieces of [0, count), as many bytes each as a thread fills in about 0.1 ms.
template <class Value>
void for_pieces(int threads, std::size_t count, const auto& body) {
  constexpr std::size_t piece = (std::size_t{1} << 20) / sizeof(Value);
  parallel_for(threads, (count + piece - 1) / piece,
               [&](std::size_t i, int) { body(i * piece, std::min(count, (i + 1) * piece)); });
}

// The image as a new one of this shape would be, but for what it holds. The system gives memory page by page as each is
// first touched, which takes longer than drawing simple pixels: the threads share it.
template <class Value>
void reshape(Image<Value>& image, const PixelRect& region, int channels, int threads) {
  if (image.width == region.width && image.height == region.height && image.channels == channels) return;
  image = {}; // the budget was asked for one of the two
  const std::size_t count = static_cast<std::size_t>(region.width) * static_cast<std::size_t>(region.height) *
                            static_cast<std::size_t>(channels);
  image.values.reserve(count);
  Value* const memory = image.values.data(); // room for so many, which are there once they are zeros below
  advise_large_pages(memory, count * sizeof(Value));
  for_pieces<Value>(threads, count, [memory](std::size_t begin, std::size_t end) {
    std::memset(static_cast<void*>(memory + begin), 0, (end - begin) * sizeof(Value));
  });
  image.values.resize(count);
  image.width = region.width, image.height = region.height, image.channels = channels;
}

// What reshape_images will hold, whatever is there already.
std::uint64_t image_bytes(const RenderOptions& options, const PixelRect& region) {
  std::uint64_t pixel = 0;
  if (options.want_rgb8) pixel += 3;
  if (options.want_radiance) pixel += 3 * sizeof(float);
  if (options.want_radiance_double) pixel += 3 * sizeof(double);
  for (const Aov aov : options.aovs) pixel += static_cast<std::uint64_t>(kind_of(aov).channels) * sizeof(float);
  return pixel * static_cast<std::uint64_t>(region.width) * static_cast<std::uint64_t>(region.height);
}

// Vertices in Geometry: in the window, and in the world.
std::uint64_t vertex_bytes(std::uint64_t window, std::uint64_t world) {
  return (sizeof(PlacedVertex) + sizeof(double)) * window + sizeof(WorldVertex) * world;
}

// Each thread's copy of the largest mesh that is on demand.
std::uint64_t bytes_on_demand(const FrameContext& context) {
  std::uint64_t most = 0;
  for (std::uint32_t o = 0; o < context.scene.objects.size(); ++o)
    if (context.geometry.storage_of(o) == Storage::on_demand)
      most = std::max<std::uint64_t>(most, context.scene.objects[o].mesh->positions.size());
  return most * sizeof(PlacedVertex) * static_cast<std::uint64_t>(context.threads);
}

std::uint64_t bytes_of(const Frame& frame) {
  std::uint64_t bytes = frame.rgb8.values.size() + frame.radiance.values.size() * sizeof(float) +
                        frame.radiance_double.values.size() * sizeof(double);
  for (const Image<float>& aov : frame.aovs) bytes += aov.values.size() * sizeof(float);
  return bytes;
}

// For what `wanted` is more than what is held already from the frame before.
void need_more(const MemoryBudget& memory, std::uint64_t wanted, std::uint64_t held, std::string_view what) {
  if (wanted > held) memory.need(wanted - held, what);
}

void reshape_images(const RenderOptions& options, const PixelRect& region, int threads, Frame& frame) {
  if (options.want_rgb8) reshape(frame.rgb8, region, 3, threads);
  else frame.rgb8 = {};
  if (options.want_radiance) reshape(frame.radiance, region, 3, threads);
  else frame.radiance = {};
  if (options.want_radiance_double) reshape(frame.radiance_double, region, 3, threads);
  else frame.radiance_double = {};
  frame.aovs.resize(options.aovs.size());
  for (std::size_t i = 0; i < options.aovs.size(); ++i) {
    Image<float>& image = frame.aovs[i];
    reshape(image, region, kind_of(options.aovs[i]).channels, threads);
    for_pieces<float>(threads, image.values.size(), [&](std::size_t begin, std::size_t end) {
      std::fill(&image.values[begin], &image.values[begin] + (end - begin),
                0.0f); // tiles write where there is a surface
    });
  }
}

std::string size_text(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height) + " pixels";
}

void check(const RenderOptions& options) {
  const auto need = [](bool holds, const char* name, const std::string& found, const std::string& expected) {
    if (!holds)
      throw std::invalid_argument("options/" + std::string(name) + ": found " + found + ", expected " + expected);
  };
  const auto is_side = [](int pixels) { return pixels >= 1 && pixels <= max_image_side; };
  need(is_side(options.width) && is_side(options.height), "width and height", size_text(options.width, options.height),
       "1 to " + std::to_string(max_image_side) + " pixels a side");
  const int tile = options.tile_size;
  need(tile >= 8 && tile <= 128 && std::has_single_bit(static_cast<unsigned>(tile)), "tile_size", std::to_string(tile),
       "8, 16, 32, 64 or 128");
  need(is_sample_count(options.samples), "samples", std::to_string(options.samples), "1, 2, 4, 8 or 16");
  need(options.threads >= 0, "threads", std::to_string(options.threads), "0 or more");
  if (!options.crop) return;
  const PixelRect& crop = *options.crop;
  const auto within = [](int first, int count, int all) { return first >= 0 && count >= 1 && count <= all - first; };
  need(within(crop.x, crop.width, options.width) && within(crop.y, crop.height, options.height), "crop",
       size_text(crop.width, crop.height) + " at (" + std::to_string(crop.x) + ", " + std::to_string(crop.y) + ")",
       "a part of the image of " + size_text(options.width, options.height));
}

// All stages, in memory that may be that of another frame.
void render_frame(const Scene& scene, const RenderOptions& options, Geometry& geometry, Bins& bins,
                  SceneShadows& shadows, const std::function<std::span<TileWorker>(int threads)>& workers_for,
                  Frame& frame) {
  check(options);
  if (const std::optional<SceneFault> fault = first_refused_fault(scene)) refuse(*fault);
  const Stopwatch whole_frame;
  FrameContext context{{scene, options}, geometry, bins};
  const PixelRect& region = context.region;
  need_more(options.memory, image_bytes(options, region), bytes_of(frame), "the image");
  reshape_images(options, region, context.threads, frame);
  frame.threads = context.threads;
  frame.counts = {}, frame.seconds = {}, frame.tile_seconds = {};
  frame.counts.pixels = static_cast<std::uint64_t>(region.width) * static_cast<std::uint64_t>(region.height);

  Stopwatch stage;
  lay_out(context, geometry);
  // Each list by itself may hold more than is wanted, from the frame before; what is on demand is never held.
  const std::uint64_t vertices = geometry.first_vertex.back(), in_world = geometry.world_stored ? vertices : 0;
  const auto more = [](std::uint64_t wanted, std::uint64_t held) { return wanted > held ? wanted - held : 0; };
  need_more(options.memory,
            vertex_bytes(more(vertices, geometry.window.size()), more(in_world, geometry.world.size())) +
                bytes_on_demand(context),
            0, "the vertices");
  transform_stored(context, geometry);
  frame.seconds.transform = stage.lap();
  bin_triangles(context, geometry, bins, frame.counts);
  if (context.uses.shadows) {
    shadows.build(context, geometry);
    context.shadows = &shadows;
  }
  frame.seconds.bin = stage.lap();
  shade_tiles(context, workers_for(frame.threads), frame);
  frame.seconds.tiles = stage.lap();
  frame.seconds.total = whole_frame.seconds();
  frame.cancelled = cancelled(options);
}

} // namespace

std::unique_ptr<TileShading> make_tile_shading(Precision precision) {
  switch (precision) {
  case Precision::double_:
    return make_double_shading();
  case Precision::float_:
    return make_float_shading();
  case Precision::fast:
    return make_fast_shading();
  case Precision::exact:
    return make_exact_shading();
  }
  throw std::invalid_argument("options/precision: found " + std::to_string(static_cast<int>(precision)) +
                              ", expected one of the enum");
}

int precision_lanes(Precision precision) {
  int lanes = 0;
  const auto look_at = [&]<class R>(R) {
    if (R::id == precision) lanes = R::lanes;
  };
  std::apply([&](auto... each) { (look_at(each), ...); }, Precisions{});
  return lanes;
}

struct Renderer::Memory {
  Geometry geometry;
  Bins bins;
  SceneShadows shadows;
  // One for each thread; made for this tile size and precision.
  std::vector<TileWorker> workers;
  int tile_size = 0;
  Precision precision = Precision::double_;

  std::span<TileWorker> workers_for(const RenderOptions& options, int threads) {
    if (tile_size != options.tile_size || precision != options.precision) workers.clear();
    tile_size = options.tile_size, precision = options.precision;
    const auto count = static_cast<std::size_t>(threads);
    while (workers.size() < count) workers.emplace_back(tile_size, make_tile_shading(precision));
    for (TileWorker& worker : workers) worker.counts = {}, worker.seconds = {};
    return {workers.data(), count};
  }
};

Renderer::Renderer() : memory_(std::make_unique<Memory>()) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::render(const Scene& scene, const RenderOptions& options, Frame& frame) {
  render_frame(
      scene, options, memory_->geometry, memory_->bins, memory_->shadows,
      [&](int threads) { return memory_->workers_for(options, threads); }, frame);
}

void render_with(const Scene& scene, const RenderOptions& options, const MakeShading& make_shading, Frame& frame) {
  Geometry geometry;
  Bins bins;
  SceneShadows shadows;
  std::vector<TileWorker> workers;
  const auto workers_for = [&](int threads) {
    for (int i = 0; i < threads; ++i) workers.emplace_back(options.tile_size, make_shading());
    return std::span(workers);
  };
  render_frame(scene, options, geometry, bins, shadows, workers_for, frame);
}

Frame render(const Scene& scene, const RenderOptions& options) {
  Frame frame;
  Renderer().render(scene, options, frame);
  return frame;
}

} // namespace refraster
