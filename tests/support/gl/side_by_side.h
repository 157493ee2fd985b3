#pragma once
// One scene, here and through OpenGL, pixel by pixel.

#include "gl/render_gl.h"
#include "tests/support/gl/colour_bound.h"

#include <string>

namespace refraster {

/// What is to be said of each pixel that differs.
enum class PixelVerdict {
  same_surface, // both show the same triangle of the same object, or both the background
  edge,         // another surface, and an edge of one of the two passes within a lattice step, 1/256 pixel
  depth,        // another surface, and both are equally far as far as floats can tell
  coverage      // another surface, for no such reason
};

struct WorstPixel {
  int x = 0, y = 0;
  double difference = 0; // in levels
  Float3 ours{0}, gl{0};
  Double3 allowed{0}; // by ColourBound; 0 where it was not asked
  std::string cause;  // edge, depth, coverage, or the largest part of the colour's bound
  std::string object; // what we show there
};

struct SideBySide {
  std::string driver;
  int width = 0, height = 0;
  // The 8-bit images.
  std::uint64_t equal = 0, off_by_one = 0, off_by_more = 0;
  // What is seen.
  std::uint64_t edge_pixels = 0, depth_pixels = 0, coverage_pixels = 0;
  double farthest_edge = 0; // of the edge pixels: largest distance to an edge, in pixels
  // Of the pixels that show the same surface: float colours.
  std::uint64_t over_bound = 0;         // farther apart than ColourBound allows
  double worst_fraction_of_bound = 0;   // the largest |difference| / bound
  std::uint64_t levels_not_rounded = 0; // GL's 8-bit values that are not its float values, rounded to nearest
  WorstPixel worst;                     // of all pixels
  WorstPixel worst_same;                // of those that show the same surface
  std::vector<WorstPixel> unexplained;  // over the bound, or another surface for no reason: the first ten
  std::uint64_t pixels() const { return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height); }
};

/// Another renderer's images of a scene.
struct OtherImages {
  std::string driver;
  Image<float> radiance;    // 3 channels
  Image<float> ids;         // 2 channels, as in GlFrame
  Image<std::uint8_t> rgb8; // 3 channels; may be empty
};

SideBySide side_by_side(const Scene& scene, const OtherImages& other, const DriverTolerances& tolerances);

/// The same with what render_gl makes. Sets the environment of the process as the profile says.
SideBySide side_by_side(const Scene& scene, int width, int height, const DriverProfile& profile);

} // namespace refraster
