#pragma once
// What is assumed of a device whose image is judged: as much as decides how far a right image may be from ours.

#include <refraster/fields.h>

#include "gl/gl_names.h"
#include "math/bounds/device_arithmetic.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
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

/// From the coarsest to the finest.
enum class DepthFormat { unorm16, unorm24, float32 };
template <>
struct EnumNames<DepthFormat> {
  static constexpr std::pair<DepthFormat, std::string_view> names[] = {
      {DepthFormat::unorm16, "unorm16"},
      {DepthFormat::unorm24, "unorm24"},
      {DepthFormat::float32, "float32"},
  };
};

/// Which of two values of a member allows a device more.
enum class Wider {
  above,
  below,
  times_relative ///< the one that is more once it is multiplied by operations.relative, the half of its unit
};

// A group of a profile declares each member in its function `fields`, by one call:
//     field("lattice", self.lattice, Range{0, 1}, Wider::above, "step of the lattice, in pixels");
// Reading, writing, ranges, the order of profiles and docs/devices.md follow from it. The order of an enum's values is
// in allows_no_more() below.

/// Coverage: corners are rounded to a lattice.
struct RasterProfile {
  double lattice = 1.0 / 256; ///< its step, in pixels; 0: positions are not rounded
  double snap_steps = 0.5;    ///< how far a corner may be moved along each axis, in steps
  SetupPositions setup_positions = SetupPositions::either;
  FillRule fill_rule = FillRule::either;
  double guard_band = 0; ///< pixels from the origin; edges farther out are cut, at one more rounding. 0: all may be

  static void fields(auto& self, auto&& field) {
    field("lattice", self.lattice, Range{0, 1}, Wider::above, "step of the corners' lattice, in pixels");
    field("snap_steps", self.snap_steps, Range{0, 4}, Wider::above, "how far a corner is moved at most, in steps");
    field("setup_positions", self.setup_positions, Range{}, Wider::above,
          "positions that depth and varyings are set up from");
    field("fill_rule", self.fill_rule, Range{}, Wider::above, "edges that belong to a triangle, y up");
    field("guard_band", self.guard_band, Range{0, 1e9}, Wider::below,
          "pixels from the origin to where edges are not cut");
  }
};

/// Interpolation of f / w and 1 / w, whose planes over the window are p(x, y) = p_c + a (x - x_c) + b (y - y_c). Off by
/// at most
///     max(units 2^-24 m, relative max |p_i|), m = max |p_i| + A |x - x_c| + B |y - y_c|, i the corners,
/// where A and B are what the slopes are summed from, which in needles is more than what is left of it. With d twice
/// the area:
///     anchor `origin`: x_c = y_c = 0, and slopes of differences of values, A = (|p_0 - p_1| |y_2 - y_0| +
///                      |p_2 - p_0| |y_0 - y_1|) / |d|, and B with x for y;
///     anchor `triangle`: c a corner, and slopes of the values themselves, A = (|p_0| |y_1 - y_2| + |p_1| |y_2 - y_0| +
///                      |p_2| |y_0 - y_1|) / |d|, and B with x for y.
/// Of the three corners that may be number 0, or c, it is the one for which m is largest.
struct InterpolationProfile {
  InterpolationAnchor anchor = InterpolationAnchor::origin;
  double units = 16;      ///< of 2^-24, of the magnitudes that a plane is summed from
  double relative = 1e-5; ///< of the greatest magnitude at a corner

  static void fields(auto& self, auto&& field) {
    field("anchor", self.anchor, Range{}, Wider::above, "where planes start");
    field("units", self.units, Range{0, 1e6}, Wider::above,
          "error in 2^-24 of the magnitudes that a plane is summed from");
    field("relative", self.relative, Range{0, 1}, Wider::above,
          "error as a fraction of the greatest value at a corner, if that is more");
  }
};

/// Texture reads. Errors of a filtered texel are in units of the texture's full scale.
struct TextureProfile {
  double place_error = 0;       ///< of the place that is read, in texels: a weight's last bit
  double nearest_error = 0;     ///< the same where no filter is
  double filter_error = 0;      ///< of a filtered texel
  double mip_error = 0.5 / 255; ///< of the texels of a level made by halving
  /// How far the level of detail may be below and above log2 of the longer side of the pixel's footprint.
  double detail_below = 0, detail_above = 0;

  static void fields(auto& self, auto&& field) {
    field("place_error", self.place_error, Range{0, 1}, Wider::above, "of the place of a filtered read, in texels");
    field("nearest_error", self.nearest_error, Range{0, 1}, Wider::above, "of the place of a nearest read, in texels");
    field("filter_error", self.filter_error, Range{0, 1}, Wider::above, "of a filtered texel, of full scale");
    field("mip_error", self.mip_error, Range{0, 1}, Wider::above, "of a texel of a mip level, of full scale");
    field("detail_below", self.detail_below, Range{0, 16}, Wider::above, "level of detail too low by at most this");
    field("detail_above", self.detail_above, Range{0, 16}, Wider::above, "level of detail too high by at most this");
  }
};

/// Depth.
struct DepthProfile {
  DepthFormat format = DepthFormat::float32; ///< of the buffer: a device takes what it is asked for

  static void fields(auto& self, auto&& field) {
    field("format", self.format, Range{}, Wider::above, "of the depth buffer");
  }
};

/// The image.
struct OutputProfile {
  double unorm_levels = 0.6; ///< a level is allowed if it is no farther from 255 times the value; 0.5 is exact
  double srgb_levels = 0.7;  ///< the same where the device encodes sRGB itself

  static void fields(auto& self, auto&& field) {
    field("unorm_levels", self.unorm_levels, Range{0.5, 255}, Wider::above,
          "of an 8-bit value from 255 times its float");
    field("srgb_levels", self.srgb_levels, Range{0.5, 255}, Wider::above, "the same where the device encodes sRGB");
  }
};

/// Declares the members of OperationErrors that bounds read. A unit is 2 relative |result|: 2^-23 of it, at least as
/// much as one in the last place, where relative is 2^-24.
void operation_fields(auto& self, auto&& field) {
  constexpr Range rounding{0x1p-24, 0.01}, units{0, 1e6}; // below 2^-24 no float is
  field("relative", self.relative, rounding, Wider::above, "of a sum, difference or product, relative");
  field("absolute", self.absolute, Range{0, 0.01}, Wider::above, "beside that, absolute: where denormals are flushed");
  field("quotient_relative", self.quotient_relative, rounding, Wider::above, "of a division, relative");
  field("root_relative", self.root_relative, rounding, Wider::above, "of a square root, relative");
  field("log2_units", self.log2_units, units, Wider::times_relative, "of log2, in units of 2 relative");
  field("log2_absolute", self.log2_absolute, Range{0, 0.01}, Wider::above, "of log2 beside that, absolute");
  field("exp2_units", self.exp2_units, units, Wider::times_relative, "of exp2, in units of 2 relative");
  field("exp2_units_by_exponent", self.exp2_units_by_exponent, units, Wider::times_relative,
        "more, for each 1 of the exponent");
  field("atan2_units", self.atan2_units, units, Wider::times_relative, "of atan(y, x), in units of 2 relative");
  field("cut_off", self.cut_off, Range{-149, 0}, Wider::above, "exp2 may be 0 below 2 to this");
}

/// Declares the members of a group of a profile.
template <class Group>
void group_fields(Group& group, auto&& field) {
  if constexpr (std::is_same_v<std::remove_const_t<Group>, OperationErrors>) operation_fields(group, field);
  else Group::fields(group, field);
}

// Whether a device of the first value may do nothing that one of the second may not.
constexpr bool allows_no_more(SetupPositions a, SetupPositions b) {
  return a == b || b == SetupPositions::either;
}
constexpr bool allows_no_more(FillRule a, FillRule b) {
  return a == b || b == FillRule::either;
}
constexpr bool allows_no_more(InterpolationAnchor a, InterpolationAnchor b) {
  return a == b || b == InterpolationAnchor::origin;
}
constexpr bool allows_no_more(DepthFormat a, DepthFormat b) {
  return a >= b;
}

/// Variables of the environment by which Mesa's drivers change what they compute; a profile may say what they are.
inline constexpr std::string_view driver_switches[] = {"GALLIVM_PERF", "GALLIUM_OVERRIDE_CPU_CAPS"};

/// What a profile was measured on, in the driver's words.
struct MeasuredDevice {
  std::string vendor, renderer, version, glsl_version;
  std::string habits;    ///< what it does where OpenGL leaves it open, beside what the members say
  int probe_version = 0; ///< of the probes: numbers of another version may mean something else

  static void fields(auto& self, auto&& field) {
    field("vendor", self.vendor, "the driver's vendor");
    field("renderer", self.renderer, "the driver's renderer");
    field("version", self.version, "its version of OpenGL");
    field("glsl_version", self.glsl_version, "its version of GLSL");
    field("habits", self.habits, "what it does where OpenGL leaves it open");
  }
  bool operator==(const MeasuredDevice&) const = default;
};

/// A device, named and versioned; printed in each report.
struct DeviceProfile {
  std::string name;
  int version = 1;     ///< of its numbers
  std::string meaning; ///< a sentence: what it describes, and where its numbers are from
  /// Which of the program's renderers draws as it says, if the variables of `environment` are set so.
  GlRenderer renderer = GlRenderer::system_default;
  std::map<std::string, std::string> environment; ///< by driver_switches
  std::optional<MeasuredDevice> measured;         ///< where it was made by probes
  RasterProfile raster;
  InterpolationProfile interpolation;
  OperationErrors operations;
  TextureProfile texture;
  DepthProfile depth;
  OutputProfile output;
  /// Where a number is from, by "group/member". Of the shipped profiles every one has a source.
  std::map<std::string, std::string> sources;

  /// Declares the groups: group("raster", self.raster, "Coverage").
  static void groups(auto& self, auto&& group) {
    group("raster", self.raster, "Coverage");
    group("interpolation", self.interpolation, "Varyings and depth");
    group("operations", self.operations, "Arithmetic of shaders");
    group("texture", self.texture, "Texture reads");
    group("depth", self.depth, "Depth");
    group("output", self.output, "The image");
  }
};

/// Calls visit("raster/lattice", value, range, wider, meaning) for each member of each group.
void for_each_member(auto& profile, auto&& visit) {
  profile.groups(profile, [&](std::string_view name, auto& group, std::string_view) {
    group_fields(group,
                 [&](std::string_view key, auto& value, const Range& range, Wider wider, std::string_view meaning) {
                   visit(std::string(name).append("/").append(key), value, range, wider, meaning);
                 });
  });
}

} // namespace refraster
