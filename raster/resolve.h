#pragma once
// From fragments to pixels: samples are averaged, values become the numbers of the output images.

#include "math/elementary.h"
#include "raster/shade.h"

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace refraster {

/// 255 times x clamped to [0, 1], rounded to the nearest integer, half to even; 0 for NaN.
template <class Real>
std::uint8_t level_of(Real x) {
  const Real scaled = minimum(positive(x), Real(1)) * Real(255);
  // Adding 2^p, with p the number of fraction bits, leaves the rounded integer in the lowest bits.
  const Real shelf = static_cast<Real>(BitsOf<Real>(1) << fraction_bits<Real>);
  return static_cast<std::uint8_t>(std::bit_cast<BitsOf<Real>>(scaled + shelf) & 0xff);
}

/// The sRGB transfer curve, IEC 61966-2-1, of x clamped to [0, 1].
template <class Real>
Real srgb_encoded(Real x) {
  const Real in_range = minimum(positive(x), Real(1));
  return in_range <= as<Real>(0.0031308) ? as<Real>(12.92) * in_range
                                         : as<Real>(1.055) * power(in_range, 1 / 2.4) - as<Real>(0.055);
}

/// Writes the tile to frame.levels and frame.radiance, those that exist. colour[c][i] is channel c of fragment i.
template <class Real>
void resolve_tile(const FrameContext& context, const VisibleTile& visible, std::span<const TileFragment> fragments,
                  const std::array<std::vector<Real>, 3>& colour, Frame& frame, FrameCounts& counts) {
  const Rgb<Real> background = as<Real>(context.scene.background);
  const int samples = context.options.samples;
  const Crop& tile = visible.tile;
  std::size_t next = 0; // fragments come in row order
  for (int y = 0; y < tile.height; ++y) {
    for (int x = 0; x < tile.width; ++x) {
      Rgb<Real> pixel = background;
      if (next < fragments.size() && fragments[next].x == x && fragments[next].y == y) {
        const auto fragment_colour = [&](std::size_t i) { return Rgb<Real>(colour[0][i], colour[1][i], colour[2][i]); };
        // The first colour plus the mean difference to it: equal colours give that colour, bit for bit.
        const Rgb<Real> first = fragment_colour(next);
        Rgb<Real> difference(Real(0));
        int covered = fragments[next].samples;
        std::size_t i = next + 1;
        for (; i < fragments.size() && fragments[i].x == x && fragments[i].y == y; ++i) {
          difference += (fragment_colour(i) - first) * static_cast<Real>(fragments[i].samples);
          covered += fragments[i].samples;
        }
        if (covered < samples) difference += (background - first) * static_cast<Real>(samples - covered);
        pixel = i == next + 1 && covered == samples ? first : first + difference / static_cast<Real>(samples);
        counts.shaded += 1;
        counts.fragments += i - next;
        next = i;
      }
      const int out_x = tile.x - context.region.x + x, out_y = tile.y - context.region.y + y;
      for (int c = 0; c < 3; ++c) {
        if (!frame.radiance.empty()) frame.radiance.at(out_x, out_y)[c] = static_cast<float>(pixel[c]);
        if (!frame.levels.empty())
          frame.levels.at(out_x, out_y)[c] =
              level_of(context.options.transfer == Transfer::srgb ? srgb_encoded(pixel[c]) : pixel[c]);
      }
    }
  }
}

} // namespace refraster
