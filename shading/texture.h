#pragma once
// Texture images and how they are sampled.

#include "math/elementary.h"
#include "math/lookup.h"
#include "shading/fields.h"

#include <vector>

namespace refraster {

enum class TextureFilter { nearest, bilinear, trilinear };

template <>
struct EnumNames<TextureFilter> {
  static constexpr std::pair<TextureFilter, std::string_view> names[] = {
      {TextureFilter::nearest, "nearest"},
      {TextureFilter::bilinear, "bilinear"},
      {TextureFilter::trilinear, "trilinear"},
  };
};

/// One image of a mip chain. Row 0 is at v = 0: the bottom row of the image file.
struct TextureLevel {
  int width = 1, height = 1;
  std::vector<float> rgb; // 3 width height values, interleaved, in [0, full_scale]

  template <class F>
  Rgb<F> texel(std::int32_t x, std::int32_t y) const {
    const float* at = &rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x))];
    return {static_cast<F>(at[0]), static_cast<F>(at[1]), static_cast<F>(at[2])};
  }
};

/// Values as stored in the file: no sRGB decoding. Immutable after loading.
struct Texture {
  double full_scale = 255;          // the stored value that means 1: 255 or 65535, exact in float
  std::vector<TextureLevel> levels; // level 0 is the image; more only where trilinear filtering asked for them
};

} // namespace refraster
