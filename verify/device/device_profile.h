#pragma once
// What is assumed of a device whose image is judged: as much as decides how far a right image may be from ours.

#include <refraster/fields.h>

#include "math/bounds/device_arithmetic.h"

#include <string>
#include <string_view>
#include <utility>

namespace refraster {

/// From which corners' positions a device takes the planes of depth and attributes.
enum class SetupPositions {
  snapped, ///< those on its lattice, as coverage
  exact,   ///< those of the vertex stage
  either
};
template <>
struct EnumNames<SetupPositions> {
  static constexpr std::pair<SetupPositions, std::string_view> names[] = {
      {SetupPositions::snapped, "snapped"},
      {SetupPositions::exact, "exact"},
      {SetupPositions::either, "either"},
  };
};

/// Which samples on an edge belong to a triangle; y as in OpenGL's window, upward.
enum class FillRule { top_left, bottom_left, bottom_right, either };
template <>
struct EnumNames<FillRule> {
  static constexpr std::pair<FillRule, std::string_view> names[] = {
      {FillRule::top_left, "top-left"},
      {FillRule::bottom_left, "bottom-left"},
      {FillRule::bottom_right, "bottom-right"},
      {FillRule::either, "either"},
  };
};

/// Where the planes of interpolated values start.
enum class InterpolationAnchor {
  triangle, ///< at a corner, or as weights of corners: errors in proportion to the corners' values
  origin    ///< at the framebuffer's lower left corner: small triangles far from it lose digits
};
template <>
struct EnumNames<InterpolationAnchor> {
  static constexpr std::pair<InterpolationAnchor, std::string_view> names[] = {
      {InterpolationAnchor::triangle, "triangle"},
      {InterpolationAnchor::origin, "origin"},
  };
};

enum class DepthFormat { unorm16, unorm24, float32 };
template <>
struct EnumNames<DepthFormat> {
  static constexpr std::pair<DepthFormat, std::string_view> names[] = {
      {DepthFormat::unorm16, "unorm16"},
      {DepthFormat::unorm24, "unorm24"},
      {DepthFormat::float32, "float32"},
  };
};

/// Coverage: corners are rounded to a lattice.
struct RasterProfile {
  double lattice = 1.0 / 256;                            ///< its step, in pixels; 0: positions are not rounded
  double snap_steps = 0.5;                               ///< how far a corner may be moved, in steps
  SetupPositions setup_positions = SetupPositions::either;
  FillRule fill_rule = FillRule::either;
  double guard_band = 0;                                 ///< pixels from the origin; farther edges are cut: 0: all are
};

/// Interpolation of f / w and 1 / w: each off by units 2^-24 of the magnitudes that its plane is summed from, or by
/// `relative` of its greatest magnitude at a corner, whichever is more.
struct InterpolationProfile {
  InterpolationAnchor anchor = InterpolationAnchor::origin;
  double units = 16;
  double relative = 1e-5;
};

/// Texture reads. Errors of a filtered texel are in units of the texture's full scale.
struct TextureProfile {
  double place_error = 0;   ///< of the place that is read, in texels: a weight's last bit
  double nearest_error = 0; ///< the same where no filter is
  double filter_error = 0;  ///< of a filtered texel
  double mip_error = 0.5 / 255; ///< of the texels of a level made by halving
  /// How far the level of detail may be below and above log2 of the longer side of the pixel's footprint.
  double detail_below = 0, detail_above = 0;
};

/// Depth.
struct DepthProfile {
  DepthFormat format = DepthFormat::float32;
};

/// The image.
struct OutputProfile {
  double unorm_levels = 0.6; ///< a level is allowed if it is no farther from 255 times the value; 0.5 is exact
  double srgb_levels = 0.7;  ///< the same where the device encodes sRGB itself
};

/// A device, named and versioned; printed in each report.
struct DeviceProfile {
  std::string name;
  int version = 1;
  std::string meaning; ///< a sentence: what it describes, and where its numbers are from
  RasterProfile raster;
  InterpolationProfile interpolation;
  OperationErrors operations;
  TextureProfile texture;
  DepthProfile depth;
  OutputProfile output;
};

} // namespace refraster
