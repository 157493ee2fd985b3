#pragma once
// Whether a device's image of a scene is right, pixel by pixel.

#include <refraster/compare.h>
#include <refraster/frame.h>
#include <refraster/render.h>

#include "raster/samples.h"
#include "verify/bounds/pixel_bounds.h"
#include "verify/images/stored_precision.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace refraster {

/// Why a pixel is as it is: the first of these that explains it. All but the last are right.
enum class PixelClass : std::uint8_t {
  exact,        ///< the reference, rounded to the image's format
  rounding,     ///< at most one level from it, and within what the device may compute
  shading,      ///< farther, and within that
  texel,        ///< so only by what the device may do in reading textures
  branch,       ///< so only by the other side of a comparison that the device may decide either way
  shadow,       ///< so only by the other answer of a shadow map, whose comparison the device may decide either way
  edge,         ///< the colour of another surface, whose edge the device may have on the other side of the sample
  depth,        ///< the colour of another surface that may be as near
  undefined,    ///< the mathematics leaves the colour undefined here
  unverifiable, ///< the device may show nearly anything here
  unexplained   ///< no right device shows this
};
template <>
struct EnumNames<PixelClass> {
  static constexpr std::pair<PixelClass, std::string_view> names[] = {
      {PixelClass::exact, "exact"},
      {PixelClass::rounding, "rounding"},
      {PixelClass::shading, "shading"},
      {PixelClass::texel, "texel"},
      {PixelClass::branch, "branch"},
      {PixelClass::shadow, "shadow"},
      {PixelClass::edge, "edge"},
      {PixelClass::depth, "depth"},
      {PixelClass::undefined, "undefined"},
      {PixelClass::unverifiable, "unverifiable"},
      {PixelClass::unexplained, "unexplained"},
  };
};
inline constexpr std::size_t pixel_classes = std::size(EnumNames<PixelClass>::names);

/// A box with a channel wider than this, in levels, says nothing: half of all there are.
inline constexpr double unverifiable_levels = 128;

/// A device's image of a scene.
struct DeviceImage {
  Image<float> colour;       ///< 3 channels, row 0 at the top, in the file's numbers
  double full_scale = 255;   ///< the number that means 1: 255, 65535, or 1 for floating point
  StoredPrecision precision; ///< of the numbers
  Transfer transfer = Transfer::linear;
  Image<float> ids;   ///< 2 channels: object and triangle in its mesh, counted from 1; 0 for none. May be empty
  Image<float> depth; ///< 1 channel: window depth in [0, 1]. May be empty
  /// Where its samples lie in a pixel, if there are several; empty: at the standard positions, y down.
  std::vector<SamplePosition> samples = {};
};

/// How an image is judged.
struct JudgeOptions {
  int samples = 1;                               ///< a pixel, as for RenderOptions
  ShaderMatrices matrices = ShaderMatrices::one; ///< of the vertex shader
  int threads = 0;                               ///< 0: as many as the machine has
  std::uint64_t seed = 1;                        ///< of the choice of pixels for `power` and attributions
  std::function<void(double)> progress = {};     ///< called with the fraction done, from one thread at a time
  MemoryBudget memory = {};                      ///< asked for images
};

/// Why a pixel is unexplained.
enum class Objection : std::uint8_t { colour, surface, depth };
template <>
struct EnumNames<Objection> {
  static constexpr std::pair<Objection, std::string_view> names[] = {
      {Objection::colour, "colour"}, {Objection::surface, "surface"}, {Objection::depth, "depth"}};
};

/// A pixel that was looked at closely.
struct JudgedDetail {
  int x = 0, y = 0;
  PixelClass found = PixelClass::exact;
  Objection objection = Objection::colour; ///< if it is unexplained
  std::uint32_t object = 0, triangle = 0;  ///< that the reference shows, counted from 1; 0 for the background
  Double3 reference{0};                    ///< as the image stores it, in levels, not rounded
  Double3 actual{0};                       ///< in levels
  ColourBox allowed;                       ///< in levels: of the surface that the reference shows
  int surfaces = 1;                        ///< how many the pixel may show
};

/// How sharp the check was: of pixels chosen at random among those that show a surface, how far apart in levels the
/// colours are that pass.
struct JudgePower {
  std::uint64_t pixels = 0;
  double below_tenth = 0, below_one = 0, below_four = 0; ///< shares: of a width below 0.1, 1 and 4 levels
  double median = 0;                                     ///< width
};

/// What makes the bounds as wide as they are: shares that add up to 1, of the same pixels.
using CauseShares = std::array<double, static_cast<std::size_t>(BoundCause::count_)>;

/// Of one object: whether its values, each once, are stored as another level than the reference's more often than
/// roundings explain. A drift that no single pixel shows.
struct ObjectBias {
  std::size_t object = 0;       ///< in the scene, from 0
  std::uint64_t values = 0;     ///< that were looked at
  double mean = 0, allowed = 0; ///< levels that the device stored beside the reference's, in the mean; and by chance
  double moved = 0, allowed_moved = 0; ///< the share of values that are stored as another level
  bool is_biased() const { return std::abs(mean) > allowed || moved > allowed_moved; }
};

/// Pixels that are unexplained and touch each other.
struct UnexplainedCluster {
  Cluster where;
  std::string object; ///< that the reference shows at its worst pixel
};

/// What was found.
struct Verdict {
  int width = 0, height = 0;
  std::array<std::uint64_t, pixel_classes> counts{}; ///< by PixelClass
  Image<std::uint8_t> classes;                       ///< 1 channel: PixelClass
  Image<float> reference;                            ///< 3 channels: linear radiance
  Image<float> object, triangle;                     ///< 1 channel each, counted from 1
  Image<float> width_levels;                ///< 1 channel: how wide the bounds are where they were needed; else 0
  std::vector<JudgedDetail> details;        ///< every pixel whose bounds were needed, row by row
  std::vector<UnexplainedCluster> clusters; ///< largest first
  JudgePower power;
  CauseShares causes{};
  std::vector<ObjectBias> biases; ///< of objects where the bounds are narrow enough to tell

  std::uint64_t count(PixelClass c) const { return counts[static_cast<std::size_t>(c)]; }
  bool is_explained() const { return count(PixelClass::unexplained) == 0; }
};

/// Judges `image` of this scene by what a device of this profile may make of it. Throws std::invalid_argument if the
/// images' sizes differ or the scene cannot be rendered, std::bad_alloc, and what the options' memory budget throws.
Verdict judge(const Scene& scene, const DeviceImage& image, const DeviceProfile& profile, const JudgeOptions& options);

} // namespace refraster
