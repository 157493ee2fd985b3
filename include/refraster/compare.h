#pragma once
// How far two images are apart, and where.

#include <refraster/image.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace refraster {

/// The unit of limits and reports. A level is what an 8-bit image counts, 0 to 255, whatever the images hold: a value v
/// of a float image is 255 v levels, a number n of a 16-bit image n / 257 levels.
enum class CompareUnit { levels, values };

/// What PSNR takes as the whole range: 255 levels, or 1.
constexpr double full_range(CompareUnit unit) {
  return unit == CompareUnit::levels ? 255 : 1;
}
/// The unit in words, as reports have it.
constexpr std::string_view unit_name(CompareUnit unit) {
  return unit == CompareUnit::levels ? "levels" : "values";
}

/// How the numbers of two images are read: those of both count to full_scale (255, 65535, or 1), and what is found is
/// told in the unit. A unit alone says that the numbers are in it.
struct PixelScale {
  double full_scale; ///< the number that means 1
  CompareUnit unit;  ///< of limits and report

  /// Numbers that count to `stored_full_scale`, told in `of_report`.
  constexpr PixelScale(double stored_full_scale, CompareUnit of_report)
      : full_scale(stored_full_scale), unit(of_report) {}
  /// Numbers that are in the unit.
  constexpr PixelScale(CompareUnit of_both) : full_scale(full_range(of_both)), unit(of_both) {}

  /// A stored number, or a difference of two, in the unit. Rounded once for 8 and 16 bits and for values, so that a
  /// limit of whole levels is met exactly.
  constexpr double in_unit(double stored) const { return stored * full_range(unit) / full_scale; }
};

/// When two images count as the same. A limit that is not set does not judge; without any, all values must be equal.
struct CompareLimits {
  std::optional<double> max_abs = {};          ///< in the unit: a value that differs by more is over the limit
  std::optional<double> max_rms = {};          ///< in the unit
  std::optional<std::uint64_t> max_count = {}; ///< so many pixels may be over the limit (over 0, if max_abs is not set)

  /// Whether any limit is set.
  bool any() const { return max_abs || max_rms || max_count; }
};

/// A pixel of which at least one value differs.
struct PixelDifference {
  int x = 0;             ///< from the left
  int y = 0;             ///< from the top
  double difference = 0; ///< of the channel that differs most; infinity if one has no difference
  std::vector<double> a; ///< all channels, in the unit
  std::vector<double> b; ///< likewise
};

inline constexpr std::size_t max_worst_pixels = 10; ///< how many pixels are told
inline constexpr std::size_t max_clusters = 10;     ///< and how many clusters

/// Pixels that touch each other, corners included, and the smallest rectangle around them.
struct Cluster {
  int x = 0;                ///< of the leftmost column
  int y = 0;                ///< of the topmost row
  int width = 0;            ///< columns
  int height = 0;           ///< rows
  std::uint64_t pixels = 0; ///< that are marked
  double largest = 0;       ///< difference in it
  int worst_x = 0;          ///< where that is: the first one, row by row
  int worst_y = 0;          ///< likewise
};

/// What compare() found. Differences are b - a, of each channel of each pixel. Two values have no difference if one is
/// NaN (which equals nothing, itself included) or infinite (which equals only the same infinity): such pixels are
/// counted, and their values kept out of every sum and maximum.
struct Comparison {
  CompareUnit unit = CompareUnit::levels; ///< of all differences and values
  int width = 0;                          ///< pixels
  int height = 0;                         ///< pixels
  int channels = 0;                       ///< values a pixel

  std::uint64_t incomparable_pixels = 0; ///< a value has no difference
  std::uint64_t nan_pixels_a = 0;        ///< with NaN in a
  std::uint64_t nan_pixels_b = 0;        ///< with NaN in b
  std::uint64_t equal_pixels = 0;        ///< all values have the same bits, and none is NaN
  std::uint64_t zero_sign_pixels = 0;    ///< differ in nothing but the sign of a zero
  std::uint64_t pixels_over = 0;         ///< incomparable, or a value is over the limit
  double max = 0;                        ///< |b - a|
  double rms = 0;                        ///< root of the mean square over all values
  double psnr_db = 0;                    ///< 20 log10(full_range / rms); infinity if rms is 0
  std::vector<double> mean;              ///< of b - a, by channel: shows a bias that no single pixel does
  std::vector<PixelDifference> worst; ///< the worst of each cluster, of pixels over the limit or, if there are none, of
                                      ///< all that differ; at most max_worst_pixels; the most different first
  std::uint64_t cluster_count = 0;    ///< of pixels over the limit
  std::vector<Cluster> clusters;      ///< at most max_clusters: those with most pixels
  bool same = false;                  ///< within the limits; never with an incomparable pixel

  /// Of each image.
  std::uint64_t pixels() const { return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height); }
};

/// The images must agree in size and channels: throws std::invalid_argument. Computed in double, row by row: the same
/// bits every time. Equality is that of the stored numbers. A value is over the limit if it differs by more than that;
/// where the images hold values (full_scale 1), by more than the limit and the rounding of both numbers to single
/// precision, 2^-24 of each, of 1 at most: levels that are stored as values differ by whole levels only so far.
Comparison compare(const Image<float>& a, const Image<float>& b, const PixelScale& scale, const CompareLimits& limits);

} // namespace refraster
