#pragma once
// From fragments to pixels: samples are averaged, values become the numbers of the output images.

#include "math/elementary.h"
#include "raster/fragments.h"
#include "raster/shade.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace refraster {

/// The colours of a tile's fragments: a plane for each channel, in the order of fragment numbers.
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

/// The sRGB transfer curve, IEC 61966-2-1, of x in [0, 1].
template <class T>
T srgb_encoded(const T& x) {
  return select(x <= as<T>(0.0031308), as<T>(12.92) * x, as<T>(1.055) * power(x, 1 / 2.4) - as<T>(0.055));
}

/// 255 times x clamped to [0, 1], rounded to the nearest integer, half to even; 0 for NaN. Each lane of the result
/// holds that integer in its lowest bits.
template <class T>
auto level_bits(const T& x, Transfer transfer) {
  using Real = RealOf<T>;
  const T in_range = minimum(positive(x), T(1));
  const T scaled = (transfer == Transfer::srgb ? srgb_encoded(in_range) : in_range) * T(255);
  // Adding 2^p, with p the number of fraction bits, leaves the rounded integer in the lowest bits.
  return bits_of(scaled + T(static_cast<Real>(BitsOf<Real>(1) << fraction_bits<Real>))) & 255;
}

/// Writes tiles to the images of a frame. Holds scratch memory: one for each thread.
template <class T>
class TileResolver {
public:
  void resolve(const FrameContext& context, const Crop& tile, std::span<const FragmentRun> runs,
               const FragmentColours<T>& colours, Frame& frame, FrameCounts& counts) {
    if (context.options.samples == 1) {
      write(context, tile, runs, colours, frame, counts);
    } else {
      average(context, runs, colours);
      write(context, tile, pixel_runs_, pixels_, frame, counts);
    }
  }

private:
  using Real = RealOf<T>;
  static constexpr int lanes = NumberTraits<T>::lanes;

  /// A background beyond the largest number of the rung is that number, as any other colour is.
  static Rgb<Real> finite_background(const FrameContext& context) {
    const Rgb<Real> rgb = as<Real>(context.scene.background);
    constexpr Real largest = std::numeric_limits<Real>::max();
    return {minimum(rgb.x, largest), minimum(rgb.y, largest), minimum(rgb.z, largest)};
  }

  // One colour for each pixel that any run touches: the first colour plus the mean difference to it, so that equal
  // colours give that colour, bit for bit. Each difference is weighted before it is added: their sum then is no larger
  // than the largest, which may be the largest number there is. Shares are exact, samples being a power of two.
  void average(const FrameContext& context, std::span<const FragmentRun> runs, const FragmentColours<T>& colours) {
    const Rgb<Real> background = finite_background(context);
    const int samples = context.options.samples;
    const auto share = [samples](int count) { return static_cast<Real>(count) / static_cast<Real>(samples); };
    pixel_runs_.clear();
    pixels_.resize(static_cast<std::uint32_t>(runs.size()));
    for (std::size_t i = 0; i < runs.size();) {
      const FragmentRun& run = runs[i]; // one pixel long
      const Rgb<Real> first = colours[run.first_fragment];
      Rgb<Real> difference(Real(0));
      int covered = 0;
      for (; i < runs.size() && runs[i].x == run.x && runs[i].y == run.y; ++i) {
        difference += (colours[runs[i].first_fragment] - first) * share(runs[i].samples);
        covered += runs[i].samples;
      }
      if (covered < samples) difference += (background - first) * share(samples - covered);
      const auto pixel = static_cast<std::uint32_t>(pixel_runs_.size());
      pixels_.set(pixel, first + difference);
      pixel_runs_.push_back({0, pixel, run.x, run.y, 1, 1});
    }
  }

  void write(const FrameContext& context, const Crop& tile, std::span<const FragmentRun> runs,
             const FragmentColours<T>& colours, Frame& frame, FrameCounts& counts) {
    std::uint32_t pixels = 0;
    for (const FragmentRun& run : runs) pixels += run.length;
    counts.shaded += pixels;
    const int left = tile.x - context.region.x, top = tile.y - context.region.y;
    if (!frame.radiance.empty()) write_radiance(context, tile, runs, colours, left, top, frame.radiance);
    if (!frame.radiance_double.empty()) write_radiance(context, tile, runs, colours, left, top, frame.radiance_double);
    if (!frame.levels.empty()) write_levels(context, tile, runs, colours, pixels, left, top, frame.levels);
  }

  template <class Value>
  static void write_radiance(const FrameContext& context, const Crop& tile, std::span<const FragmentRun> runs,
                             const FragmentColours<T>& colours, int left, int top, Image<Value>& image) {
    const Rgb<Real> background = as<Real>(context.scene.background);
    const auto put = [](Value* at, const Rgb<Real>& rgb) {
      using Narrow = std::conditional_t<sizeof(Value) < sizeof(Real), Value, Real>;
      constexpr Real largest =
          static_cast<Real>(std::numeric_limits<Narrow>::max()); // a finite double may lie beyond a float's
      for (int c = 0; c < 3; ++c) at[c] = static_cast<Value>(minimum(maximum(rgb[c], -largest), largest));
    };
    for (int y = 0; y < tile.height; ++y)
      for (int x = 0; x < tile.width; ++x) put(image.at(left + x, top + y), background);
    for (const FragmentRun& run : runs)
      for (std::uint32_t i = 0; i < run.length; ++i)
        put(image.at(left + run.x + static_cast<int>(i), top + run.y), colours[run.first_fragment + i]);
  }

  // The three levels of a pixel are packed into 32 bits, whole registers at a time; runs are copied to their place in
  // the tile; rows go to the image.
  void write_levels(const FrameContext& context, const Crop& tile, std::span<const FragmentRun> runs,
                    const FragmentColours<T>& colours, std::uint32_t pixels, int left, int top,
                    Image<std::uint8_t>& image) {
    const Transfer transfer = context.options.transfer;
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
    tile_levels_.assign(width * static_cast<std::size_t>(tile.height), packed(as<T>(context.scene.background))[0]);
    for (const FragmentRun& run : runs)
      std::copy_n(&packed_[run.first_fragment], run.length, &tile_levels_[run.y * width + run.x]);
    for (int y = 0; y < tile.height; ++y) {
      const std::int32_t* const from = &tile_levels_[static_cast<std::size_t>(y) * width];
      std::uint8_t* const to = image.at(left, top + y);
      for (std::size_t x = 0; x < width; ++x) {
        to[3 * x] = static_cast<std::uint8_t>(from[x]);
        to[3 * x + 1] = static_cast<std::uint8_t>(from[x] >> 8);
        to[3 * x + 2] = static_cast<std::uint8_t>(from[x] >> 16);
      }
    }
  }

  std::vector<FragmentRun> pixel_runs_;
  FragmentColours<T> pixels_;
  std::vector<std::int32_t> packed_, tile_levels_;
};

} // namespace refraster
