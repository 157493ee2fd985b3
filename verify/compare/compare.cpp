#include "verify/compare/compare.h"

#include "verify/compare/clusters.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>

namespace refraster {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

bool same_bits(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

std::vector<double> values_of(const float* pixel, int channels, const PixelScale& scale) {
  std::vector<double> values;
  for (int c = 0; c < channels; ++c) values.push_back(scale.in_unit(static_cast<double>(pixel[c])));
  return values;
}

/// The worst pixel of each of these clusters; of equals the first in the image comes first.
std::vector<PixelDifference> worst_of(std::vector<Cluster> clusters, const Image<float>& a, const Image<float>& b,
                                      const PixelScale& scale) {
  std::sort(clusters.begin(), clusters.end(), [](const Cluster& p, const Cluster& q) {
    return std::tuple(-p.largest, p.worst_y, p.worst_x) < std::tuple(-q.largest, q.worst_y, q.worst_x);
  });
  clusters.resize(std::min(clusters.size(), max_worst_pixels));
  std::vector<PixelDifference> worst;
  for (const Cluster& c : clusters)
    worst.push_back({c.worst_x, c.worst_y, c.largest, values_of(a.at(c.worst_x, c.worst_y), a.channels, scale),
                     values_of(b.at(c.worst_x, c.worst_y), b.channels, scale)});
  return worst;
}

/// How far the rounding of two values to single precision may have moved their difference, in the unit. Beyond 1 it
/// grows no more: a limit that is small beside large values means what it says.
double storage_rounding(const float* a, const float* b, int channels, const PixelScale& scale) {
  if (scale.full_scale != 1) return 0; // integers are exact
  double largest = 0;
  for (int c = 0; c < channels; ++c)
    largest = std::max(largest, std::min(std::abs(static_cast<double>(a[c])), 1.0) +
                                    std::min(std::abs(static_cast<double>(b[c])), 1.0));
  return scale.in_unit(0x1p-24 * largest);
}

/// Sums over all values seen so far.
struct Sums {
  std::vector<double> signed_by_channel;
  std::vector<std::uint64_t> values_by_channel;
  double squares = 0;
  std::uint64_t values = 0;

  explicit Sums(int channels)
      : signed_by_channel(static_cast<std::size_t>(channels)), values_by_channel(static_cast<std::size_t>(channels)) {}

  void add(std::size_t channel, double difference) {
    signed_by_channel[channel] += difference;
    ++values_by_channel[channel];
    squares += difference * difference;
    ++values;
  }
};

bool within(const Comparison& found, const CompareLimits& limits) {
  if (found.incomparable_pixels > 0) return false;
  if (!limits.any()) return found.equal_pixels == found.pixels();
  if (limits.max_rms && !(found.rms <= *limits.max_rms)) return false;
  if (limits.max_abs || limits.max_count) return found.pixels_over <= limits.max_count.value_or(0);
  return true;
}

} // namespace

double value_difference(float a, float b) {
  if (a == b) return 0; // so that the same infinity twice is no difference
  const double difference = std::abs(static_cast<double>(b) - static_cast<double>(a));
  return std::isfinite(difference) ? difference : none;
}

CompareLimits converted(const CompareLimits& limits, CompareUnit from, CompareUnit to) {
  CompareLimits result = limits;
  for (std::optional<double>* const limit : {&result.max_abs, &result.max_rms})
    if (*limit) *limit = **limit * full_range(to) / full_range(from);
  return result;
}

Image<double> pixel_differences(const Image<float>& a, const Image<float>& b, const PixelScale& scale) {
  Image<double> differences(a.width, a.height, 1);
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x)
      for (int c = 0; c < a.channels; ++c)
        *differences.at(x, y) =
            std::max(*differences.at(x, y), scale.in_unit(value_difference(a.at(x, y)[c], b.at(x, y)[c])));
  return differences;
}

Image<std::uint8_t> pixels_over(const Image<float>& a, const Image<float>& b, const Image<double>& differences,
                                const PixelScale& scale, const CompareLimits& limits) {
  const double limit = limits.max_abs.value_or(0);
  Image<std::uint8_t> over(a.width, a.height, 1);
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const double rounding = limit > 0 ? storage_rounding(a.at(x, y), b.at(x, y), a.channels, scale) : 0;
      *over.at(x, y) = *differences.at(x, y) > limit + rounding;
    }
  return over;
}

Comparison compare(const Image<float>& a, const Image<float>& b, const PixelScale& scale, const CompareLimits& limits) {
  if (a.width != b.width || a.height != b.height || a.channels != b.channels)
    throw std::invalid_argument("compare: found images of different sizes, expected the same size and channels");
  Comparison found;
  found.unit = scale.unit;
  found.width = a.width;
  found.height = a.height;
  found.channels = a.channels;
  const auto channels = static_cast<std::size_t>(a.channels);
  const Image<double> differences = pixel_differences(a, b, scale);
  const Image<std::uint8_t> over = pixels_over(a, b, differences, scale, limits);
  Sums sums(a.channels);

  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const float *pixel_a = a.at(x, y), *pixel_b = b.at(x, y);
      bool equal = true, nan_a = false, nan_b = false;
      const double largest = *differences.at(x, y);
      for (std::size_t c = 0; c < channels; ++c) {
        nan_a |= std::isnan(pixel_a[c]);
        nan_b |= std::isnan(pixel_b[c]);
        equal &= same_bits(pixel_a[c], pixel_b[c]);
        const double difference = scale.in_unit(value_difference(pixel_a[c], pixel_b[c]));
        if (difference == none) continue;
        sums.add(c, pixel_b[c] < pixel_a[c] ? -difference : difference);
        found.max = std::max(found.max, difference);
      }
      equal &= !nan_a;
      found.nan_pixels_a += nan_a;
      found.nan_pixels_b += nan_b;
      found.incomparable_pixels += largest == none;
      found.equal_pixels += equal;
      found.zero_sign_pixels += !equal && largest == 0;
      found.pixels_over += *over.at(x, y);
    }
  }

  if (sums.values > 0) found.rms = std::sqrt(sums.squares / static_cast<double>(sums.values));
  found.psnr_db = found.rms > 0 ? 20 * std::log10(full_range(scale.unit) / found.rms) : none;
  for (std::size_t c = 0; c < channels; ++c) {
    const auto values = static_cast<double>(std::max<std::uint64_t>(sums.values_by_channel[c], 1));
    found.mean.push_back(sums.signed_by_channel[c] / values);
  }
  found.clusters = clusters_of(over, differences);
  found.worst = worst_of(found.clusters.empty() ? clusters_over(differences, 0) : found.clusters, a, b, scale);
  found.cluster_count = found.clusters.size();
  found.clusters.resize(std::min(found.clusters.size(), max_clusters));
  found.same = within(found, limits);
  return found;
}

} // namespace refraster
