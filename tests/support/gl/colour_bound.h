#pragma once
// How far the colour of a pixel on a GPU may be from ours when nothing is wrong: docs/verification.md derives it.

#include <refraster/render.h>

#include "gl/gl_names.h"
#include "raster/vertex/subpixel.h"
#include "raster/vertex/transform.h"

#include <string_view>

namespace refraster {

inline constexpr double our_lattice = 1.0 / subpixels; // pixels: the step to which window positions are rounded

/// What the bound assumes of a driver. Units in the last place are of float: 2^-24 relative.
struct DriverTolerances {
  double lattice = our_lattice;
  double plane_ulp = 6;   // of plane equations anchored at the framebuffer's origin, the lower left corner
  double atan_ulp = 352;  // of atan(y, x)
  double power_ulp = 2.1; // of pow(x, s), for each unit of s; and 16 beside
  double texel_error = 0; // of a filtered texel, in units of the texture's full scale
  /// How far the level of detail may be below and above log2 of the longer side of the pixel's footprint, in texels.
  double detail_below = 0, detail_above = 0;
};

/// docs/verification.md says where each number is from.
struct DriverProfile {
  std::string_view name;
  GlRenderer renderer;
  const char* environment; // of Mesa, GALLIVM_PERF; null where it plays no part
  DriverTolerances tolerances;
};
inline constexpr double logarithm_error = 0.0861; // log2(m) - (m - 1) at most, for m in [1, 2)
inline constexpr double mip_rounding = 0.5 / 255; // of the levels of a mip chain, stored in 8 bits
inline constexpr DriverProfile driver_profiles[] = {
    // As it is shipped: texels are filtered in fixed point, the footprint's longer side is the larger component, and
    // mip levels are only mixed halfway between them.
    {"llvmpipe",
     GlRenderer::llvmpipe,
     "",
     {.texel_error = 1.07 / 255 + 0.5 / 255 + mip_rounding,
      .detail_below = 0.5 + 0.25 + logarithm_error,
      .detail_above = 0.25 + logarithm_error}},
    // With all of these shortcuts switched off.
    {"llvmpipe-precise",
     GlRenderer::llvmpipe,
     "no_aos_sampling,no_brilinear,no_rho_approx,no_quad_lod",
     {.texel_error = mip_rounding, .detail_below = logarithm_error, .detail_above = logarithm_error}},
    {"softpipe",
     GlRenderer::softpipe,
     nullptr,
     {.texel_error = mip_rounding, .detail_below = 0.5 + logarithm_error, .detail_above = logarithm_error}},
};

/// SwiftShader, Chromium's software driver, as tests/system/webgl uses it. WebGL reports its lattice, in pixels:
/// 2^-SUBPIXEL_BITS.
constexpr DriverTolerances swiftshader_tolerances(double lattice) {
  return {.lattice = lattice,
          .texel_error = 1.07 / 255,
          .detail_below = 0.5 + logarithm_error,
          .detail_above = logarithm_error};
}

/// How far apart two renderers' roundings of one window position may be, along each axis: half a step of each lattice.
constexpr double rounded_apart(const DriverTolerances& driver) {
  return (our_lattice + driver.lattice) / 2;
}

/// The exact colour of a surface at a pixel centre, from corners that are not snapped; and, for each channel, how far a
/// right image may be from it, and the largest of the causes that this is the sum of.
struct AllowedColour {
  Double3 exact, either_way;
  std::string_view main_cause;
};

/// How much of the bound to add up. The least costs a seventh; it is never above the whole.
enum class BoundPart { least, whole };

/// Bounds for the pixels of one scene at one size.
class ColourBound {
public:
  ColourBound(const Scene& scene, int width, int height, const DriverTolerances& driver);

  /// For this triangle at this pixel. Infinitely far where floats decide nothing.
  AllowedColour at(std::size_t object, std::uint32_t triangle, int x, int y, BoundPart part) const;

  /// How far window depth may be off there.
  double depth_error(std::size_t object, std::uint32_t triangle, int x, int y) const;

  /// The same triangle's window depth, unsnapped.
  double depth(std::size_t object, std::uint32_t triangle, int x, int y) const;

  const Geometry& geometry() const { return geometry_; }
  TriangleRef ref(std::size_t object, std::uint32_t triangle) const {
    return TriangleFinder(scene_, geometry_).at(geometry_.first_triangle[object] + triangle);
  }

private:
  struct Setup;
  Setup set_up(std::size_t object, std::uint32_t triangle) const;

  /// How far a pixel's centre is from the framebuffer's origin, which OpenGL has at the lower left, in x and in y.
  Double2 from_origin(int x, int y) const { return {x + 0.5, height_ - (y + 0.5)}; }

  const Scene& scene_;
  int width_, height_;
  DriverTolerances driver_;
  Geometry geometry_;
};

} // namespace refraster
