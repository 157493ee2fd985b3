#pragma once
// From fragments to pixels: samples are averaged, values become the numbers of the output images.

#include "raster/buffer.h"
#include "raster/resolve/fragment_colours.h"
#include "raster/resolve/rgb8.h"
#include "raster/shade/shade.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace refraster {

/// Writes tiles to the images of a frame. Holds scratch memory: one for each thread.
template <class T>
class TileResolver {
public:
  /// Of a pixel that has several fragments the mean takes the place of the first.
  void resolve(const FrameContext& context, const PixelRect& tile, std::span<const FragmentRun> runs,
               FragmentColours<T>& colours, Frame& frame, FrameCounts& counts) {
    if (context.options.samples > 1) {
      average(context, runs, colours);
      runs = pixel_runs_;
    }
    write(context, tile, runs, colours, frame, counts);
    resolved_runs_ = runs;
    resolved_ = &colours;
  }

  /// take(x, y, colour) for each pixel of the tile just resolved that shows a surface; x, y of the full image.
  template <class Take>
  void for_each_pixel(const PixelRect& tile, const Take& take) const {
    for (const FragmentRun& run : resolved_runs_)
      for (std::uint32_t i = 0; i < run.length; ++i)
        take(tile.x + run.x + static_cast<int>(i), tile.y + run.y, (*resolved_)[run.first_fragment + i]);
  }

private:
  using Real = typename FragmentColours<T>::Real;
  static constexpr int lanes = NumberTraits<T>::lanes;

  /// A background beyond the largest number of the precision is that number, as any other colour is.
  static Rgb<Real> finite_background(const FrameContext& context) {
    const Rgb<Real> rgb = as<Real>(shown_background(context));
    const Real largest = largest_number<Real>();
    return {min(rgb.x, largest), min(rgb.y, largest), min(rgb.z, largest)};
  }

  // One colour for each pixel that any run touches, in pixel_runs_: the first colour plus the mean difference to it, so
  // that equal colours give that colour, bit for bit; only -0 becomes 0, the mean difference being that. Each
  // difference is weighted before it is added: their sum then is no larger than the largest, which may be the largest
  // number there is. Weights are exact, samples being a power of two; where the background is transparent they are
  // rounded, and what then exceeds the largest number is written as that.
  void average(const FrameContext& context, std::span<const FragmentRun> runs, FragmentColours<T>& colours) {
    const Rgb<Real> background = finite_background(context);
    const int samples = context.options.samples;
    const bool is_blended = context.options.background == Background::blended;
    const auto fraction = [](int count, int all) {
      return Real(static_cast<RealOf<Real>>(count)) / Real(static_cast<RealOf<Real>>(all));
    };
    pixel_runs_.clear();
    for (std::size_t i = 0; i < runs.size();) {
      const FragmentRun& run = runs[i];
      if (run.samples == samples) {
        colours.add_zero(run.first_fragment, run.length);
        pixel_runs_.push_back(run);
        ++i;
        continue;
      }
      const Rgb<Real> first = colours[run.first_fragment];
      Rgb<Real> difference(Real(0));
      const auto is_here = [&](std::size_t k) { return k < runs.size() && runs[k].x == run.x && runs[k].y == run.y; };
      int covered = 0;
      for (std::size_t k = i; is_here(k); ++k) covered += runs[k].samples;
      const int shown = is_blended ? samples : covered; // of which the weights are fractions
      for (; is_here(i); ++i)
        difference += (colours[runs[i].first_fragment] - first) * fraction(runs[i].samples, shown);
      if (covered < shown) difference += (background - first) * fraction(shown - covered, shown);
      colours.set(run.first_fragment, first + difference);
      pixel_runs_.push_back(run);
    }
  }

  void write(const FrameContext& context, const PixelRect& tile, std::span<const FragmentRun> runs,
             const FragmentColours<T>& colours, Frame& frame, FrameCounts& counts) {
    for (const FragmentRun& run : runs) counts.shaded += run.length;
    if constexpr (NumberTraits<T>::decides) write_images(context, tile, runs, colours, frame);
  }

  void write_images(const FrameContext& context, const PixelRect& tile, std::span<const FragmentRun> runs,
                    const FragmentColours<T>& colours, Frame& frame) {
    const int left = tile.x - context.region.x, top = tile.y - context.region.y;
    if (!frame.radiance.empty()) write_radiance(context, tile, runs, colours, left, top, frame.radiance);
    if (!frame.radiance_double.empty()) write_radiance(context, tile, runs, colours, left, top, frame.radiance_double);
    if (!frame.rgb8.empty()) write_rgb8(context, tile, runs, colours, left, top, frame.rgb8);
  }

  static Real within(const Real& x, const Real& largest) { return min(max(x, -largest), largest); }

  template <class Value>
  static void write_radiance(const FrameContext& context, const PixelRect& tile, std::span<const FragmentRun> runs,
                             const FragmentColours<T>& colours, int left, int top, Image<Value>& image) {
    const Rgb<Real> background = as<Real>(shown_background(context));
    const auto put = [](Value* at, const Rgb<Real>& rgb) {
      for (int c = 0; c < 3; ++c) {
        // A finite double may lie beyond a float's.
        constexpr double most = std::min(NumberTraits<Value>::largest, NumberTraits<Real>::largest);
        at[c] = static_cast<Value>(static_cast<RealOf<Real>>(within(rgb[c], Real(static_cast<RealOf<Real>>(most)))));
      }
    };
    for (int y = 0; y < tile.height; ++y)
      for (int x = 0; x < tile.width; ++x) put(image.at(left + x, top + y), background);
    for (const FragmentRun& run : runs)
      for (std::uint32_t i = 0; i < run.length; ++i)
        put(image.at(left + run.x + static_cast<int>(i), top + run.y), colours[run.first_fragment + i]);
  }

  // The three levels of a pixel are packed into 32 bits, whole registers at a time; runs are copied to their place in
  // the tile; rows go to the image.
  void write_rgb8(const FrameContext& context, const PixelRect& tile, std::span<const FragmentRun> runs,
                  const FragmentColours<T>& colours, int left, int top, Image<std::uint8_t>& image) {
    const Transfer transfer = context.options.transfer;
    if constexpr (!NumberTraits<T>::has_lanes) {
      const auto put = [&](int x, int y, const Rgb<T>& rgb) {
        for (int c = 0; c < 3; ++c) image.at(left + x, top + y)[c] = level_of(rgb[c], transfer);
      };
      for (int y = 0; y < tile.height; ++y)
        for (int x = 0; x < tile.width; ++x) put(x, y, as<T>(shown_background(context)));
      for (const FragmentRun& run : runs)
        for (std::uint32_t i = 0; i < run.length; ++i)
          put(run.x + static_cast<int>(i), run.y, colours[run.first_fragment + i]);
      return;
    } else if (transfer == Transfer::srgb) {
      write_words<Transfer::srgb>(context, tile, runs, colours, left, top, image);
    } else {
      write_words<Transfer::linear>(context, tile, runs, colours, left, top, image);
    }
  }

  template <Transfer transfer>
  void write_words(const FrameContext& context, const PixelRect& tile, std::span<const FragmentRun> runs,
                   const FragmentColours<T>& colours, int left, int top, Image<std::uint8_t>& image) {
    using Words = VectorOf<std::int32_t, lanes>;
    const std::uint32_t fragments = colours.fragments();
    words_.resize_uninitialized(fragments + 2 * lanes);
    for (std::uint32_t i = 0; i < fragments; i += lanes) store_lanes(&words_[i], rgb8_words<transfer>(colours.load(i)));
    // From left to right and row by row: what whole registers write beyond a run is overwritten by what comes next.
    const auto width = static_cast<std::size_t>(tile.width), pixels = width * static_cast<std::size_t>(tile.height);
    tile_words_.resize_uninitialized(pixels + lanes);
    const Words background = rgb8_words<transfer>(as<T>(shown_background(context)));
    std::size_t next = 0;
    const auto fill_until = [&](std::size_t end) {
      for (; next < end; next += lanes) store_lanes(&tile_words_[next], background);
    };
    for (const FragmentRun& run : runs) {
      const std::size_t begin = run.y * width + run.x;
      fill_until(begin);
      for (std::size_t i = 0; i < run.length; i += lanes)
        store_lanes(&tile_words_[begin + i], load_lanes<Words>(&words_[run.first_fragment + i]));
      next = begin + run.length;
    }
    fill_until(pixels);
    for (int y = 0; y < tile.height; ++y)
      store_rgb8(&tile_words_[static_cast<std::size_t>(y) * width], tile.width, image.at(left, top + y));
  }

  std::vector<FragmentRun> pixel_runs_;
  std::span<const FragmentRun> resolved_runs_; // of the last tile
  const FragmentColours<T>* resolved_ = nullptr;
  Buffer<std::int32_t> words_, tile_words_;
};

} // namespace refraster
