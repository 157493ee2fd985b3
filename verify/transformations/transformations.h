#pragma once
// What kind of difference: known transformations, one of which may make two images equal.

#include <refraster/compare.h>
#include <refraster/image.h>

#include "verify/images/stored_precision.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace refraster {

enum class Transformation {
  srgb_curve_added,
  srgb_curve_missing,
  upside_down,
  mirrored,
  red_blue_exchanged,
  shifted,
  premultiplied,
  unpremultiplied,
  video_range,
  video_range_removed,
  scaled,
  half_size,
  double_size
};

/// A way in which images go wrong as a whole, and what it costs to undo it. It is undone on the image that loses less
/// to rounding: by a map that flattens differences where there is one. What rounding remains is the difference of the
/// undone image and the other: slope times the rounding of what was undone, and that of the other.
struct KnownTransformation {
  Transformation which;
  std::string_view name;   // in reports
  std::string_view words;  // "b is a ..."
  std::string_view undone; // how
  double slope;     // at most so much steeper than 1 within [0, 1]: rounding to a step of 8 or 16 bits grows by it
  double condition; // relative rounding, of floating point, grows by it
  double float_roundings; // of 2^-24 of the result: of a program that made the image in single precision
};

/// The slope of the inverse sRGB curve ((v + 0.055) / 1.055)^2.4 at 1, its steepest; its condition v f'/f is at
/// most 2.4. A curve in single precision is off by 16 + 8.1 / 2.4 roundings (docs/verification.md, pow).
inline constexpr double srgb_slope = 2.4 / 1.055, srgb_condition = 2.4, srgb_float_roundings = 16 + 8.1 / 2.4;

/// The closed list. Of 8 bits beside 8 bits remain: 2 levels of the sRGB curve and of alpha, else 1, which is half a
/// level of each image: two programs that round the same picture. See undoing_tolerance().
inline constexpr std::array<KnownTransformation, 13> known_transformations = {{
    {Transformation::srgb_curve_added, "srgb_curve_added", "with the sRGB curve once too often",
     "the inverse curve on b", srgb_slope, srgb_condition, srgb_float_roundings},
    {Transformation::srgb_curve_missing, "srgb_curve_missing", "with the sRGB curve missing", "the inverse curve on a",
     srgb_slope, srgb_condition, srgb_float_roundings},
    {Transformation::upside_down, "upside_down", "turned upside down", "the rows of b from below", 1, 1, 0},
    {Transformation::mirrored, "mirrored", "mirrored, left to right", "the columns of b from the right", 1, 1, 0},
    {Transformation::red_blue_exchanged, "red_blue_exchanged", "with R and B exchanged", "R and B of b exchanged", 1, 1,
     0},
    {Transformation::shifted, "shifted", "shifted by whole pixels",
     "b moved back by up to 128 pixels; where both have the pixel", 1, 1, 0},
    {Transformation::premultiplied, "premultiplied", "premultiplied by alpha", "a times alpha, which is rounded too", 2,
     2, 1},
    {Transformation::unpremultiplied, "unpremultiplied", "with the multiplication by alpha missing",
     "b times alpha, which is rounded too", 2, 2, 1},
    {Transformation::video_range, "video_range", "in video range, 16 to 235", "16 + 219/255 of a", 219.0 / 255, 1, 2},
    {Transformation::video_range_removed, "video_range_removed", "stretched as if it were in video range",
     "16 + 219/255 of b", 219.0 / 255, 1, 2},
    {Transformation::scaled, "scaled", "scaled by a constant", "the lighter image times the constant", 1, 1, 1},
    {Transformation::half_size, "half_size", "at half size", "the mean of 2 x 2 pixels of a, or one of them", 1, 1, 4},
    {Transformation::double_size, "double_size", "at double size", "the mean of 2 x 2 pixels of b, or one of them", 1,
     1, 4},
}};

constexpr const KnownTransformation& known(Transformation which) {
  return known_transformations[static_cast<std::size_t>(which)];
}

/// At most one pixel in so many may differ after undoing by more than the limit and the rounding: 99.9 % are explained.
inline constexpr std::uint64_t one_unexplained_in = 1000;

/// An image and what its numbers mean.
struct StoredImage {
  const Image<float>& image;
  double full_scale; // 255, 65535, or 1
  StoredPrecision precision;

  double levels(int x, int y, int c) const { return static_cast<double>(image.at(x, y)[c]) * 255 / full_scale; }
};

/// A transformation that was found, and how far apart the images are once it is undone, in levels.
struct FoundTransformation {
  Transformation which;
  double factor = 1; // of scaled: b = factor a
  int x = 0, y = 0;  // of shifted: b is so many pixels to the right and down
  std::uint64_t pixels = 0,
                within = 0; // that both images have (0: known by the sizes alone), and of these the equal ones
  double equal_within = 0;  // what they are equal within: the largest difference of them
  double max = 0, rms = 0;  // of all pixels
};

/// How far apart, in levels, the undone image and the other may be at a pixel whose largest values are these: the limit
/// and what rounding leaves. Where `other` is of 8 or 16 bits, the undone image is rounded to its steps, as any program
/// would: of slope s and 8 bits, floor(limit + s / 2 + 1/2 + 1/2) levels.
double undoing_tolerance(const KnownTransformation& which, const StoredPrecision& undone, const StoredPrecision& other,
                         double limit, double undone_levels, double other_levels);

/// The transformation of which b differs from a, of images of one size and number of channels; nothing if none is
/// found. limit: in levels, as to --max-abs. alpha: 1 is opaque; may be empty. A transformation is found if undoing it
/// leaves 99.9 % of the pixels within undoing_tolerance(), and says something:
/// - of the pixels that are beyond this as the images are, it makes at least nine in ten equal;
/// - it is not because the image to meet has one colour only: ten times as many pixels as remain unequal differ from
///   its most common values by more;
/// - of the values that it explains, no more than ten in eleven are explained by their being cut off at 0 or at full
///   scale.
/// Of several the one is given that leaves the fewest pixels unequal, then the smallest differences.
std::optional<FoundTransformation> find_transformation(const StoredImage& a, const StoredImage& b,
                                                       const Image<float>& alpha, double limit);

/// For images of other sizes: half_size or double_size, or nothing. If the pixels do not agree (an image that was
/// rendered at another size, and not scaled), pixels is 0.
std::optional<FoundTransformation> find_size_transformation(const StoredImage& a, const StoredImage& b, double limit);

/// "b is a turned upside down: then equal within 1 level".
std::string transformation_text(const FoundTransformation& found, CompareUnit unit);

} // namespace refraster
