#pragma once
// What probes say of a device: measured, without margins.

#include <refraster/fields.h>

#include "gl/render_gl.h"

#include <string_view>
#include <utility>
#include <vector>

namespace refraster {

/// In pixels, along both axes, in a viewport of this size a side.
struct SnapGrid {
  int viewport = 0;
  double step = 0;       ///< of the lattice; 0: none was seen, so that it is at most `resolution`
  double moved = 0;      ///< how far a corner was moved at most, but for `resolution`
  double resolution = 0; ///< of the probe
};

/// Samples on these edges belong to a triangle, y upward; other: on others, or not the same everywhere.
enum class TieRule { top_left, top_right, bottom_left, bottom_right, other };
template <>
struct EnumNames<TieRule> {
  static constexpr std::pair<TieRule, std::string_view> names[] = {
      {TieRule::top_left, "top-left"},         {TieRule::top_right, "top-right"}, {TieRule::bottom_left, "bottom-left"},
      {TieRule::bottom_right, "bottom-right"}, {TieRule::other, "another"},
  };
};

struct TieFacts {
  TieRule rule = TieRule::other;
  bool shared_edges_drawn_once = false; ///< each sample on an edge that two triangles share
};

/// The largest errors, in units of 2^-24 of the magnitudes that planes are summed from: see InterpolationProfile in
/// verify/device/device_profile.h. For planes through corners where the vertex stage puts them, or on the lattice; and
/// for planes that start at a corner, or at the framebuffer's origin.
struct PlaneErrors {
  double exact_from_corner = 0, exact_from_origin = 0;
  double snapped_from_corner = 0, snapped_from_origin = 0;
};

struct PlaneFacts {
  PlaneErrors varyings; ///< of f / w and 1 / w, which may both be off
  PlaneErrors depth;    ///< gl_FragCoord.z and the buffer, in 32-bit float
  double constant = 0;  ///< of a varying that is the same at all corners: relative error, in 2^-24
  double samples = 0;   ///< pixels looked at
};

/// Largest errors over 2^16 mantissas of each binade that was looked at, and as many numbers between; in 2^-24.
struct FunctionErrors {
  double sum = 0, product = 0;                 ///< relative
  double quotient = 0;                         ///< relative; of a / b and 1 / b
  double root = 0, inverse_root = 0;           ///< relative; of sqrt, inversesqrt
  double log2_relative = 0, log2_absolute = 0; ///< together: |error| <= log2_relative |log2 x| + log2_absolute
  double exp2_relative = 0;                    ///< for |x| <= 1
  double exp2_by_exponent = 0;                 ///< more, for each 1 of |x|
  double atan2_relative = 0;
};

struct HabitFacts {
  bool fuses = false;           ///< a * b + c with one rounding, where it is written so
  bool keeps_denormals = false; ///< as results of products
  bool reads_denormals = false; ///< as factors
  double min_exp2 = 0;          ///< the least whole x, down to -160, of which exp2(x) is not 0
  bool min_of_nan_is_number = false, max_of_nan_is_number = false; ///< in both orders
};

/// Of 8-bit textures. Places are in texels, values in units of full scale.
struct TextureFacts {
  double nearest_place = 0; ///< how far from the border of two texels the wrong one is read, at most; of 1024 texels
  double nearest_resolution = 0;   ///< between the places that were tried for that
  double weight_place = 0;         ///< how far a filtered read is from the place that it was asked for, at most
  double value = 0;                ///< what is wrong with a filtered texel at multiples of 1/256 texel, at most
  double value_anywhere = 0;       ///< the same at other places, with what is wrong with the place
  double value_between_levels = 0; ///< the same, at multiples, halfway between two mip levels
  int weights = 0;                 ///< how many different values there are between 0 and full scale
};

/// How far the level of detail that is read is below and above log2 of the longer side of the pixel's footprint, at
/// most; with what the weights between two levels make of it.
struct DetailFacts {
  double below = 0, above = 0;
};

/// How far a stored level is from 255 times the value, or times its sRGB encoding, at most. Values are 1/256 level
/// apart, or closer.
struct OutputFacts {
  double unorm = 0, srgb = 0;
  bool whole_levels_are_exact = false;
};

struct DeviceFacts {
  GlDriver driver;
  int subpixel_bits = 0; ///< as the driver says
  std::vector<SnapGrid> snap_grids;
  TieFacts ties;
  PlaneFacts planes;
  FunctionErrors functions;
  HabitFacts habits;
  TextureFacts texture_reads;
  DetailFacts detail;
  OutputFacts output;
};

} // namespace refraster
