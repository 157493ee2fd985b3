#pragma once
// What a frame is: its precision, images and counts.

#include <refraster/fields.h>
#include <refraster/image.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

namespace refraster {

/// A number type for interpolation and shading, all the way from a sample's weights to the pixel. Which triangle a
/// sample sees is decided before, once, for all of them: images of two precisions differ in values, never in shape.
enum class Precision {
  double_, ///< the reference: the same bits on every machine
  float_,  ///< speed, with GPU-like arithmetic: the same bits on every machine
  fast,    ///< more speed, last bits of float given up
  exact    ///< the truth: the same formulas in 60 digits; slow
};

template <>
struct EnumNames<Precision> {
  static constexpr std::pair<Precision, std::string_view> names[] = {{Precision::double_, "double"},
                                                                     {Precision::float_, "float"},
                                                                     {Precision::fast, "fast"},
                                                                     {Precision::exact, "exact"}};
};

/// Images beside the colour (arbitrary output variables), each of the nearest surface at the pixel centre; 0 where there
/// is none, but for depth. aov_kinds says what each is.
enum class Aov { depth, normal, position, uv, albedo, triangle, object, distance, alpha, material, count_ };

/// What the values of an AOV are: floats, or whole numbers, which are kept as floats too.
enum class AovValues { floats, numbers };

/// What several samples of a pixel make of an AOV that is resolved over them.
enum class AovMean {
  none,   ///< nothing: the value is always that of one surface
  covered ///< the mean over those samples that see a surface
};

/// What there is to know of an AOV.
struct AovKind {
  std::string_view name = {};                     ///< on the command line and in file names
  int channels = 1;                               ///< of the image
  AovValues values = AovValues::floats;           ///< what they are
  AovMean mean = AovMean::covered;                ///< over samples
  std::array<std::string_view, 3> exr_names = {}; ///< of the channels, as layers of an EXR file
  std::string_view meaning = {};                  ///< for help and documentation
};

/// All of them, in the order of Aov. Help, file formats, the names of layers and docs/aovs.md follow from this list; what
/// an AOV's value is stands in raster/shade/aov.cpp.
inline constexpr AovKind aov_kinds[] = {
    {"depth", 1, AovValues::floats, AovMean::covered, {"depth.Z"},
     "window depth, 0 at the near plane to 1 at the far plane and where there is no surface: no distance"},
    {"normal", 3, AovValues::floats, AovMean::covered, {"N.X", "N.Y", "N.Z"},
     "unit shading normal, world space; turned to the eye where a two-sided object shows its back"},
    {"position", 3, AovValues::floats, AovMean::covered, {"P.X", "P.Y", "P.Z"}, "world space"},
    {"uv", 2, AovValues::floats, AovMean::covered, {"uv.U", "uv.V"},
     "texture coordinates as interpolated, not wrapped"},
    {"albedo", 3, AovValues::floats, AovMean::covered, {"albedo.R", "albedo.G", "albedo.B"},
     "texture colour times kd or base_color; for a measured BRDF its value at normal incidence times pi"},
    {"triangle", 1, AovValues::numbers, AovMean::none, {"triangle.ID"},
     "number of the triangle in its object's mesh, from 1"},
    {"object", 1, AovValues::numbers, AovMean::none, {"object.ID"}, "number of the object in the scene, from 1"},
    {"distance", 1, AovValues::floats, AovMean::covered, {"Z"},
     "from the camera, along the axis of the view, in units of the scene"},
    {"alpha", 1, AovValues::floats, AovMean::none, {"alpha.A"},
     "fraction of the pixel's samples that see a surface"},
    {"material", 1, AovValues::numbers, AovMean::none, {"material.ID"},
     "number of the material among those of its object's file, from 1; the object's own comes after these"},
};
static_assert(std::size(aov_kinds) == static_cast<std::size_t>(Aov::count_));

/// Of one AOV.
constexpr const AovKind& kind_of(Aov aov) {
  return aov_kinds[static_cast<std::size_t>(aov)];
}

/// Up to so many triangles in an object a float tells one from the next; beyond, it is the nearest to the index.
inline constexpr std::size_t max_exact_triangle_id = std::size_t{1} << 24;

/// Seconds of wall time in each stage of a frame.
struct StageSeconds {
  double transform = 0; ///< vertices
  double bin = 0;       ///< triangles, to the tiles that they may touch; and into the tree of shadows
  double tiles = 0;     ///< visibility, shading, resolve
  double total = 0;     ///< of the whole frame
};

/// What the tiles' time was spent on: seconds of each thread, added up.
struct TileSeconds {
  double visibility = 0;      ///< coverage and depth
  double attribute_setup = 0; ///< listing what is visible, and setting it up for interpolation
  double shading = 0;         ///< interpolation and fragment functions
  double resolve = 0;         ///< averaging samples, writing pixels
  /// Of all four.
  double sum() const { return visibility + attribute_setup + shading + resolve; }

  /// Adds each.
  TileSeconds& operator+=(const TileSeconds& other) {
    visibility += other.visibility, attribute_setup += other.attribute_setup;
    shading += other.shading, resolve += other.resolve;
    return *this;
  }
};

/// What the mathematics leaves undefined, a fragment function defines and counts, so that a run report can say how
/// often a pixel rests on a convention instead of a formula.
enum class Undefined {
  zero_normal,      ///< the interpolated normal is 0: the triangle's own normal is used
  no_normal,        ///< and that is 0 too: ambient light only
  eye_at_surface,   ///< the camera is at the surface point: no direction to the eye, v = 0
  light_at_surface, ///< the light is at the surface point: no direction to it, contributes 0
  no_half_vector,   ///< l = -v: no half vector, no lobe
  zero_to_the_zero, ///< glossiness 0 and a cosine of 0: 0^0 = 1
  unmeasured_brdf,  ///< every table sample around the direction is marked as never measured: 0
  not_finite,       ///< overflow in a channel: the largest finite number; NaN: 0
  bad_uv,           ///< a texture coordinate is NaN or infinite: taken as 0
  count_
};

/// Names of the cases, by Undefined, as run reports have them.
inline constexpr std::array<std::string_view, static_cast<std::size_t>(Undefined::count_)> undefined_names = {
    "zero_normal",     "no_normal",  "eye_at_surface", "light_at_surface", "no_half_vector", "zero_to_the_zero",
    "unmeasured_brdf", "not_finite", "bad_uv"};

/// How often each case was met: per light and shaded sample where it concerns a light.
struct UndefinedCounts {
  std::array<std::uint64_t, static_cast<std::size_t>(Undefined::count_)> counts{}; ///< by Undefined

  /// How often `which` was met.
  std::uint64_t& operator[](Undefined which) { return counts[static_cast<std::size_t>(which)]; }
  /// The same.
  std::uint64_t operator[](Undefined which) const { return counts[static_cast<std::size_t>(which)]; }
  /// Adds each.
  UndefinedCounts& operator+=(const UndefinedCounts& other) {
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += other.counts[i];
    return *this;
  }
};

/// What a frame met. The same for every thread count and tile size.
struct FrameCounts {
  std::uint64_t triangles = 0;       ///< in the scene
  std::uint64_t not_finite = 0;      ///< dropped: a vertex with NaN or infinity
  std::uint64_t outside = 0;         ///< dropped: wholly outside the view
  std::uint64_t degenerate = 0;      ///< dropped: no area, before or after snapping
  std::uint64_t culled = 0;          ///< dropped: seen from behind, with "cull": "back"
  std::uint64_t between_samples = 0; ///< dropped: covers no sample's row or column
  std::uint64_t clipped = 0;         ///< of those drawn: reach behind the eye, past a depth plane or the guard band
  std::uint64_t drawn = 0;           ///< the others
  std::uint64_t pixels = 0;          ///< in the image or crop
  std::uint64_t shaded = 0;          ///< pixels that see a surface
  std::uint64_t fragments = 0;       ///< shaded for them: one a pixel and triangle seen; the same number with 1 sample
  std::uint64_t lane_slots = 0;      ///< lanes computed for them: fragments / lane_slots is the occupancy
  UndefinedCounts undefined;         ///< what rests on a convention

  /// Adds each.
  FrameCounts& operator+=(const FrameCounts& other) {
    triangles += other.triangles, not_finite += other.not_finite, outside += other.outside;
    degenerate += other.degenerate, culled += other.culled, between_samples += other.between_samples;
    clipped += other.clipped, drawn += other.drawn, pixels += other.pixels, shaded += other.shaded;
    fragments += other.fragments, lane_slots += other.lane_slots, undefined += other.undefined;
    return *this;
  }
};

/// The images of a frame, and what it took.
struct Frame {
  Image<std::uint8_t> rgb8;       ///< 3 channels; empty if not wanted
  Image<float> radiance;          ///< 3 channels, unclamped; empty if not wanted
  Image<double> radiance_double;  ///< the same, exactly as the precision computed it; empty if not wanted
  std::vector<Image<float>> aovs; ///< in the order of RenderOptions::aovs
  FrameCounts counts;             ///< what it met
  StageSeconds seconds;           ///< wall time
  TileSeconds tile_seconds;       ///< what the tiles' time was spent on
  int threads = 0;                ///< used
  bool cancelled = false;         ///< whether it was given up: RenderOptions::cancel
};

} // namespace refraster
