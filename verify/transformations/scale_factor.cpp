#include "verify/transformations/scale_factor.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace refraster {
namespace {

struct Ratio {
  double ratio, weight;
};

/// The ratio up to which there is half of the weight: the least sum of weight |ratio - k| is there.
double weighted_median(std::vector<Ratio>& ratios) {
  std::sort(ratios.begin(), ratios.end(), [](const Ratio& p, const Ratio& q) { return p.ratio < q.ratio; });
  double whole = 0;
  for (const Ratio& r : ratios) whole += r.weight;
  double sum = 0;
  for (const Ratio& r : ratios) {
    sum += r.weight;
    if (2 * sum >= whole) return r.ratio;
  }
  return 0;
}

} // namespace

double scale_factor(const StoredImage& a, const StoredImage& b) {
  constexpr std::uint64_t most = 1 << 20;
  const auto width = static_cast<std::uint64_t>(a.image.width);
  const std::uint64_t pixels = width * static_cast<std::uint64_t>(a.image.height);
  const int colours = a.image.channels == 4 ? 3 : a.image.channels; // alpha does not scale
  const std::uint64_t stride = (pixels * static_cast<std::uint64_t>(colours) / most + 1) | 1;
  const auto cut_off = [](const StoredImage& image, double levels) {
    return image.precision.saturates() && levels >= 255;
  };
  std::vector<Ratio> ratios;
  for (std::uint64_t i = 0; i < pixels; i += stride)
    for (int c = 0; c < colours; ++c) {
      const int x = static_cast<int>(i % width), y = static_cast<int>(i / width);
      const double p = a.levels(x, y, c), q = b.levels(x, y, c);
      const bool usable = p != 0 && std::isfinite(p) && std::isfinite(q) && !cut_off(a, p) && !cut_off(b, q);
      if (usable) ratios.push_back({q / p, std::abs(p)});
    }
  return weighted_median(ratios);
}

} // namespace refraster
