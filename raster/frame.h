#pragma once
// What is asked of a frame, and what it is: options, images, counts.

#include "scene/image.h"
#include "scene/memory_budget.h"
#include "shading/undefined.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace refraster {

/// Images beside the colour, each of the nearest surface at the pixel centre; 0 where there is none.
enum class Aov {
  depth,    // 1 channel: window depth in [0, 1]; 1 where there is no surface
  normal,   // 3: unit shading normal, world space
  position, // 3: world space
  uv,       // 2: as interpolated, not wrapped
  albedo,   // 3: texture colour times kd; for a measured BRDF its value at normal incidence times pi
  triangle, // 1: index of the triangle in its object's mesh, counted from 1; see max_exact_triangle_id
  object,   // 1: index of the object in the scene, counted from 1
  count_
};
/// Up to so many triangles in an object a float tells one from the next; beyond, it is the nearest to the index.
inline constexpr std::size_t max_exact_triangle_id = std::size_t{1} << 24;

/// Their names on the command line and in file names, and their channels, in the order of the enum.
inline constexpr std::string_view aov_names[] = {"depth", "normal", "position", "uv", "albedo", "triangle", "object"};
inline constexpr int aov_channels[] = {1, 3, 3, 2, 3, 1, 1};

/// A rectangle of pixels; x, y from the top left.
struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;
};

enum class Transfer { linear, srgb };

struct RenderOptions {
  int width = 1280, height = 720;        // of the full image: 1 to 16384 each
  std::vector<PixelRect> crop;           // none, or one within the image: only these pixels, with the same values
  std::string_view precision = "double"; // a name in math/precisions.h
  int samples = 1;                       // a pixel: 1, 2, 4, 8 or 16 at the standard positions; shaded once a triangle
  int threads = 0;                       // 0: as many as the machine has
  int tile_size = 64;                    // 8 to 128, a power of two. Changes no pixel.
  // What to make. Only what is asked for is computed and takes memory.
  bool want_rgb8 = true;                // 8-bit image
  bool want_radiance = false;           // float image
  bool want_radiance_double = false;    // the same before it is rounded to float, to measure a precision by
  Transfer transfer = Transfer::linear; // of the 8-bit image
  std::vector<Aov> aovs;
  std::function<void(double)> progress;      // called with the fraction done, in [0, 1], from one thread at a time
  const std::atomic<bool>* cancel = nullptr; // when it becomes true, the frame is given up
  MemoryBudget memory;                       // asked for images and vertices
};

/// Seconds of wall time in each stage of a frame.
struct StageSeconds {
  double transform = 0, bin = 0, tiles = 0, total = 0;
};

/// What the tiles' time was spent on: seconds of each thread, added up.
struct TileSeconds {
  double visibility = 0;      // coverage and depth
  double attribute_setup = 0; // listing what is visible, and setting it up for interpolation
  double shading = 0;         // interpolation and fragment functions
  double resolve = 0;         // averaging samples, writing pixels
  double sum() const { return visibility + attribute_setup + shading + resolve; }

  TileSeconds& operator+=(const TileSeconds& other) {
    visibility += other.visibility, attribute_setup += other.attribute_setup;
    shading += other.shading, resolve += other.resolve;
    return *this;
  }
};

/// What a frame met. The same for every thread count and tile size.
struct FrameCounts {
  std::uint64_t triangles = 0;       // in the scene
  std::uint64_t not_finite = 0;      // dropped: a vertex with NaN or infinity
  std::uint64_t outside = 0;         // dropped: wholly outside the view
  std::uint64_t degenerate = 0;      // dropped: no area, before or after snapping
  std::uint64_t culled = 0;          // dropped: seen from behind, with "cull": "back"
  std::uint64_t between_samples = 0; // dropped: covers no sample's row or column
  std::uint64_t clipped = 0;         // of those drawn: reach behind the eye, past a depth plane or the guard band
  std::uint64_t drawn = 0;
  std::uint64_t pixels = 0;     // in the image or crop
  std::uint64_t shaded = 0;     // pixels that see a surface
  std::uint64_t fragments = 0;  // shaded for them: one a pixel and triangle seen; the same number with 1 sample
  std::uint64_t lane_slots = 0; // lanes computed for them: fragments / lane_slots is the occupancy
  UndefinedCounts undefined;

  FrameCounts& operator+=(const FrameCounts& other) {
    triangles += other.triangles, not_finite += other.not_finite, outside += other.outside;
    degenerate += other.degenerate, culled += other.culled, between_samples += other.between_samples;
    clipped += other.clipped, drawn += other.drawn, pixels += other.pixels, shaded += other.shaded;
    fragments += other.fragments, lane_slots += other.lane_slots, undefined += other.undefined;
    return *this;
  }
};

struct Frame {
  Image<std::uint8_t> rgb8;       // 3 channels; empty if not wanted
  Image<float> radiance;          // 3 channels, unclamped; empty if not wanted
  Image<double> radiance_double;  // the same, exactly as the precision computed it; empty if not wanted
  std::vector<Image<float>> aovs; // in the order of RenderOptions::aovs
  FrameCounts counts;
  StageSeconds seconds;
  TileSeconds tile_seconds;
  int threads = 0; // used
  bool cancelled = false;
};

} // namespace refraster
