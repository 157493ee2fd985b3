#include "verify/compare.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

namespace refraster {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

bool same_bits(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

/// The pixels seen so far that differ most, in order. A newcomer goes behind those it equals, so that ties stay in the
/// order of the image.
class Worst {
public:
  void see(int x, int y, double difference, const float* a, const float* b, int channels) {
    if (kept_.size() == worst_pixels_kept && !(difference > kept_.back().difference)) return;
    const auto place = std::upper_bound(kept_.begin(), kept_.end(), difference,
                                        [](double d, const PixelDifference& p) { return d > p.difference; });
    kept_.insert(place, {x, y, difference, {a, a + channels}, {b, b + channels}});
    if (kept_.size() > worst_pixels_kept) kept_.pop_back();
  }
  std::vector<PixelDifference> take() { return std::move(kept_); }

private:
  std::vector<PixelDifference> kept_;
};

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

Image<double> pixel_differences(const Image<float>& a, const Image<float>& b) {
  Image<double> differences(a.width, a.height, 1);
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x)
      for (int c = 0; c < a.channels; ++c)
        *differences.at(x, y) = std::max(*differences.at(x, y), value_difference(a.at(x, y)[c], b.at(x, y)[c]));
  return differences;
}

Comparison compare(const Image<float>& a, const Image<float>& b, CompareUnit unit, const CompareLimits& limits) {
  assert(a.width == b.width && a.height == b.height && a.channels == b.channels);
  Comparison found;
  found.unit = unit;
  found.width = a.width;
  found.height = a.height;
  found.channels = a.channels;
  const auto channels = static_cast<std::size_t>(a.channels);
  const double limit = limits.max_abs.value_or(0);
  const Image<double> differences = pixel_differences(a, b);
  Sums sums(a.channels);
  Worst worst;

  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const float *pixel_a = a.at(x, y), *pixel_b = b.at(x, y);
      bool equal = true, nan_a = false, nan_b = false;
      const double largest = *differences.at(x, y);
      for (std::size_t c = 0; c < channels; ++c) {
        nan_a |= std::isnan(pixel_a[c]);
        nan_b |= std::isnan(pixel_b[c]);
        equal &= same_bits(pixel_a[c], pixel_b[c]);
        const double difference = value_difference(pixel_a[c], pixel_b[c]);
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
      found.pixels_over += largest > limit;
      if (largest > 0) worst.see(x, y, largest, pixel_a, pixel_b, a.channels);
    }
  }

  if (sums.values > 0) found.rms = std::sqrt(sums.squares / static_cast<double>(sums.values));
  found.psnr_db = found.rms > 0 ? 20 * std::log10(full_range(unit) / found.rms) : none;
  for (std::size_t c = 0; c < channels; ++c) {
    const auto values = static_cast<double>(std::max<std::uint64_t>(sums.values_by_channel[c], 1));
    found.mean.push_back(sums.signed_by_channel[c] / values);
  }
  found.worst = worst.take();
  found.clusters = clusters_over(differences, limit);
  found.cluster_count = found.clusters.size();
  found.clusters.resize(std::min(found.clusters.size(), clusters_kept));
  found.same = within(found, limits);
  return found;
}

} // namespace refraster
