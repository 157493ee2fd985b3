#pragma once
// Texture images.

#include <refraster/fields.h>
#include <refraster/memory.h>
#include <refraster/vector.h>

#include <memory>
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

/// What is seen beyond the image's edges: it again, or the texels of its edge.
enum class TextureWrap { repeat, clamp };

template <>
struct EnumNames<TextureWrap> {
  static constexpr std::pair<TextureWrap, std::string_view> names[] = {{TextureWrap::repeat, "repeat"},
                                                                       {TextureWrap::clamp, "clamp"}};
};

/// What the numbers of an image file mean: values, or values by the curve of sRGB (IEC 61966-2-1).
enum class ColourSpace { linear, srgb };

template <>
struct EnumNames<ColourSpace> {
  static constexpr std::pair<ColourSpace, std::string_view> names[] = {{ColourSpace::linear, "linear"},
                                                                       {ColourSpace::srgb, "srgb"}};
};

/// Which of an image's values a texture of single numbers has, an opacity. automatic: alpha, if the image has it, else
/// luminance. alpha: 1 of an image without. luminance: 0.2126 R + 0.7152 G + 0.0722 B (ITU-R BT.709) of the values as
/// stored; what is grey is taken as it is.
enum class ScalarChannel { automatic, red, green, blue, alpha, luminance };

template <>
struct EnumNames<ScalarChannel> {
  static constexpr std::pair<ScalarChannel, std::string_view> names[] = {
      {ScalarChannel::automatic, "auto"}, {ScalarChannel::red, "red"},     {ScalarChannel::green, "green"},
      {ScalarChannel::blue, "blue"},      {ScalarChannel::alpha, "alpha"}, {ScalarChannel::luminance, "luminance"}};
};

/// One image of a mip chain. Row 0 is at v = 0: the bottom row of the image file. At most 65536 texels a side
/// and 2^28 in all.
struct TextureLevel {
  int width = 1;           ///< texels
  int height = 1;          ///< texels
  PaddedVector<float> rgb; ///< 3 width height values, interleaved, in [0, full_scale]
};

/// Values as stored in the file, or what decode_srgb() has made of them. Immutable after loading.
struct Texture {
  /// The stored value that means 1: 255 or 65535, exact in float; 1 where sRGB is decoded.
  double full_scale = 255;
  std::vector<TextureLevel> levels; ///< level 0 is the image; more only where trilinear filtering asked for them
};

/// Appends all smaller levels to a texture that has level 0 only: each side is half of that below, rounded down, at
/// least 1, down to 1 x 1. A texel is the mean of the area that it covers in the level below (a box filter): of 2 x 2
/// texels, and for odd sides of up to 3 x 3 with the outer ones cut. Means are rounded to float once a level.
/// Throws std::invalid_argument for another number of levels, or of values.
void build_mip_levels(Texture& texture);

/// Makes linear values, of which 1 means 1, of those of an sRGB image: each is decoded in double and rounded to float
/// once. To be called before build_mip_levels(), so that means are those of light. Throws std::invalid_argument for a
/// texture of more levels than one.
void decode_srgb(Texture& texture);

/// A texture as a material has it: an image, and how it is read. Its colour at the texture coordinates (u, v) is that
/// of the image at (u, v) * scale + offset.
struct TextureMap {
  std::shared_ptr<const Texture> texture = {};    ///< null: white
  TextureFilter filter = TextureFilter::bilinear; ///< trilinear wants a texture with all its levels
  TextureWrap wrap = TextureWrap::repeat;         ///< beyond the image's edges
  Double2 scale{1};                               ///< of texture coordinates; finite
  Double2 offset{0};                              ///< added to them; finite

  /// Whether the image is read otherwise than at the texture coordinates themselves, repeated.
  bool is_placed() const { return wrap != TextureWrap::repeat || scale != Double2(1) || offset != Double2(0); }
};

} // namespace refraster
