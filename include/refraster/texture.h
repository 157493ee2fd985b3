#pragma once
// Texture images.

#include <refraster/fields.h>
#include <refraster/memory.h>

#include <string_view>
#include <utility>
#include <vector>

namespace refraster {

/// nearest: the texel that holds the point. bilinear: between four texels of the image, at every size on screen.
/// trilinear: between the two mip levels whose texels are nearest to the size of a pixel.
enum class TextureFilter { nearest, bilinear, trilinear };

template <>
struct EnumNames<TextureFilter> {
  static constexpr std::pair<TextureFilter, std::string_view> names[] = {{TextureFilter::nearest, "nearest"},
                                                                         {TextureFilter::bilinear, "bilinear"},
                                                                         {TextureFilter::trilinear, "trilinear"}};
};

/// One image of a mip chain. Row 0 is at v = 0: the bottom row of the image file. At most 65536 texels a side
/// and 2^28 in all.
struct TextureLevel {
  int width = 1;           ///< texels
  int height = 1;          ///< texels
  PaddedVector<float> rgb; ///< 3 width height values, interleaved, in [0, full_scale]
};

/// Values as stored in the file: no sRGB decoding. Immutable after loading.
struct Texture {
  double full_scale = 255;          ///< the stored value that means 1: 255 or 65535, exact in float
  std::vector<TextureLevel> levels; ///< level 0 is the image; more only where trilinear filtering asked for them
};

/// Appends all smaller levels to a texture that has level 0 only: each side is half of that below, rounded down, at
/// least 1, down to 1 x 1. A texel is the mean of the area that it covers in the level below (a box filter): of 2 x 2
/// texels, and for odd sides of up to 3 x 3 with the outer ones cut. Means are rounded to float once a level.
/// Throws std::invalid_argument for another number of levels, or of values.
void build_mip_levels(Texture& texture);

} // namespace refraster
