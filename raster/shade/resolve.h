#pragma once
// From fragments to pixels: samples are averaged, values become the numbers of the output images.

#include "math/elementary.h"
#include "raster/shade/fragments.h"
#include "raster/shade/shade.h"
#include "shading/srgb_curve.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace refraster {

/// The colours of a tile's fragments, in the order of fragment numbers: of lanes, a plane for each channel.
template <class T>
class FragmentColours {
public:
  using Real = RealOf<T>;
  static constexpr std::uint32_t lanes = NumberTraits<T>::lanes;

  /// Room for whole registers beyond the last fragment.
  void resize(std::uint32_t fragments) {
    for (std::vector<Real>& channel : channel_) channel.resize(fragments + lanes);
  }
  /// All lanes; beyond the last fragment of a group they hold nothing, and are overwritten by the next group.
  void store(std::uint32_t first, const Rgb<T>& rgb) {
    for (int c = 0; c < 3; ++c) std::memcpy(&channel_[static_cast<std::size_t>(c)][first], &rgb[c].v, sizeof rgb[c].v);
  }
  Rgb<T> load(std::uint32_t first) const {
    Rgb<T> rgb;
    for (int c = 0; c < 3; ++c) std::memcpy(&rgb[c].v, &channel_[static_cast<std::size_t>(c)][first], sizeof rgb[c].v);
    return rgb;
  }
  Rgb<Real> operator[](std::uint32_t i) const { return {channel_[0][i], channel_[1][i], channel_[2][i]}; }
  void set(std::uint32_t i, const Rgb<Real>& rgb) {
    for (int c = 0; c < 3; ++c) channel_[static_cast<std::size_t>(c)][i] = rgb[c];
  }

private:
  std::array<std::vector<Real>, 3> channel_;
};

/// Of a number without lanes, one after the other.
template <class T>
  requires(!NumberTraits<T>::has_lanes)
class FragmentColours<T> {
public:
  using Real = T; // of a channel
  static constexpr std::uint32_t lanes = 1;

  void resize(std::uint32_t fragments) { rgb_.resize(fragments); }
  void store(std::uint32_t first, const Rgb<T>& rgb) { rgb_[first] = rgb; }
  Rgb<T> operator[](std::uint32_t i) const { return rgb_[i]; }
  void set(std::uint32_t i, const Rgb<T>& rgb) { rgb_[i] = rgb; }

private:
  std::vector<Rgb<T>> rgb_;
};

/// 255 times x clamped to [0, 1], rounded to the nearest integer, half to even. For a number without lanes that a
/// double can be made of.
template <class T>
std::uint8_t level_of(const T& x, Transfer transfer) {
  const T in_range = min(max0(x), T(1));
  const Cell<T> at = floor_and_fraction((transfer == Transfer::srgb ? srgb_encoded(in_range) : in_range) * T(255));
  const bool up = at.fraction > T(0.5) || (!(at.fraction < T(0.5)) && at.index % 2 != 0);
  return static_cast<std::uint8_t>(at.index + (up ? 1 : 0));
}

/// 255 times x clamped to [0, 1], rounded to the nearest integer, half to even; 0 for NaN. Each lane of the result
/// holds that integer in its lowest bits.
template <class T>
auto level_bits(const T& x, Transfer transfer) {
  using Real = RealOf<T>;
  const T in_range = min(max0(x), T(1));
  const T scaled = (transfer == Transfer::srgb ? srgb_encoded(in_range) : in_range) * T(255);
  // Adding 2^p, with p the number of fraction bits, leaves the rounded integer in the lowest bits.
  return bits_of(scaled + T(static_cast<Real>(BitsOf<Real>(1) << fraction_bits<Real>))) & 255;
}

/// Writes tiles to the images of a frame. Holds scratch memory: one for each thread.
template <class T>
class TileResolver {
public:
  void resolve(const FrameContext& context, const PixelRect& tile, std::span<const FragmentRun> runs,
               const FragmentColours<T>& colours, Frame& frame, FrameCounts& counts) {
    if (context.options.samples == 1) {
      write(context, tile, runs, colours, frame, counts);
    } else {
      average(context, runs, colours);
      write(context, tile, pixel_runs_, pixels_, frame, counts);
    }
    resolved_runs_ = context.options.samples == 1 ? runs : std::span<const FragmentRun>(pixel_runs_);
    resolved_ = context.options.samples == 1 ? &colours : &pixels_;
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

  // One colour for each pixel that any run touches: the first colour plus the mean difference to it, so that equal
  // colours give that colour, bit for bit. Each difference is weighted before it is added: their sum then is no larger
  // than the largest, which may be the largest number there is. Weights are exact, samples being a power of two; where
  // the background is transparent they are rounded, and what then exceeds the largest number is written as that.
  void average(const FrameContext& context, std::span<const FragmentRun> runs, const FragmentColours<T>& colours) {
    const Rgb<Real> background = finite_background(context);
    const int samples = context.options.samples;
    const bool is_blended = context.options.background == Background::blended;
    const auto fraction = [](int count, int all) {
      return Real(static_cast<RealOf<Real>>(count)) / Real(static_cast<RealOf<Real>>(all));
    };
    pixel_runs_.clear();
    pixels_.resize(static_cast<std::uint32_t>(runs.size()));
    for (std::size_t i = 0; i < runs.size();) {
      const FragmentRun& run = runs[i]; // one pixel long
      const Rgb<Real> first = colours[run.first_fragment];
      Rgb<Real> difference(Real(0));
      const auto is_here = [&](std::size_t k) { return k < runs.size() && runs[k].x == run.x && runs[k].y == run.y; };
      int covered = 0;
      for (std::size_t k = i; is_here(k); ++k) covered += runs[k].samples;
      const int shown = is_blended ? samples : covered; // of which the weights are fractions
      for (; is_here(i); ++i)
        difference += (colours[runs[i].first_fragment] - first) * fraction(runs[i].samples, shown);
      if (covered < shown) difference += (background - first) * fraction(shown - covered, shown);
      const auto pixel = static_cast<std::uint32_t>(pixel_runs_.size());
      pixels_.set(pixel, first + difference);
      pixel_runs_.push_back({0, pixel, run.x, run.y, 1, 1});
    }
  }

  void write(const FrameContext& context, const PixelRect& tile, std::span<const FragmentRun> runs,
             const FragmentColours<T>& colours, Frame& frame, FrameCounts& counts) {
    std::uint32_t pixels = 0;
    for (const FragmentRun& run : runs) pixels += run.length;
    counts.shaded += pixels;
    if constexpr (NumberTraits<T>::decides) write_images(context, tile, runs, colours, pixels, frame);
  }

  void write_images(const FrameContext& context, const PixelRect& tile, std::span<const FragmentRun> runs,
                    const FragmentColours<T>& colours, std::uint32_t pixels, Frame& frame) {
    const int left = tile.x - context.region.x, top = tile.y - context.region.y;
    if (!frame.radiance.empty()) write_radiance(context, tile, runs, colours, left, top, frame.radiance);
    if (!frame.radiance_double.empty()) write_radiance(context, tile, runs, colours, left, top, frame.radiance_double);
    if (!frame.rgb8.empty()) write_rgb8(context, tile, runs, colours, pixels, left, top, frame.rgb8);
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
                  const FragmentColours<T>& colours, std::uint32_t pixels, int left, int top,
                  Image<std::uint8_t>& image) {
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
    } else {
      const auto packed = [&](const Rgb<T>& rgb) {
        return __builtin_convertvector(level_bits(rgb.x, transfer) | level_bits(rgb.y, transfer) << 8 |
                                           level_bits(rgb.z, transfer) << 16,
                                       VectorOf<std::int32_t, lanes>);
      };
      packed_.resize(pixels + lanes);
      for (std::uint32_t i = 0; i < pixels; i += lanes) {
        const auto levels = packed(colours.load(i));
        std::memcpy(&packed_[i], &levels, sizeof levels);
      }
      const auto width = static_cast<std::size_t>(tile.width);
      tile_rgb8_.assign(width * static_cast<std::size_t>(tile.height), packed(as<T>(shown_background(context)))[0]);
      for (const FragmentRun& run : runs)
        std::copy_n(&packed_[run.first_fragment], run.length, &tile_rgb8_[run.y * width + run.x]);
      for (int y = 0; y < tile.height; ++y) {
        const std::int32_t* const from = &tile_rgb8_[static_cast<std::size_t>(y) * width];
        std::uint8_t* const to = image.at(left, top + y);
        for (std::size_t x = 0; x < width; ++x) {
          to[3 * x] = static_cast<std::uint8_t>(from[x]);
          to[3 * x + 1] = static_cast<std::uint8_t>(from[x] >> 8);
          to[3 * x + 2] = static_cast<std::uint8_t>(from[x] >> 16);
        }
      }
    }
  }

  std::vector<FragmentRun> pixel_runs_;
  FragmentColours<T> pixels_;
  std::span<const FragmentRun> resolved_runs_; // of the last tile
  const FragmentColours<T>* resolved_ = nullptr;
  std::vector<std::int32_t> packed_, tile_rgb8_;
};

} // namespace refraster
