#include "bench/measure/image_error.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

namespace refraster::bench {
namespace {

ImageError::Figures figures(std::vector<double>& errors) {
  if (errors.empty()) return {};
  ImageError::Figures found;
  for (const double error : errors) {
    found.max = std::max(found.max, error);
    found.mean += error / static_cast<double>(errors.size());
  }
  const auto nth = errors.begin() + static_cast<std::ptrdiff_t>((errors.size() - 1) * 999 / 1000);
  std::nth_element(errors.begin(), nth, errors.end());
  found.p99_9 = *nth;
  return found;
}

double displayed(double value) {
  return 255 * std::clamp(value, 0.0, 1.0);
}

} // namespace

ImageError image_error(const Frame& frame, const Frame& reference) {
  assert(frame.rgb8.values.size() == reference.rgb8.values.size());
  ImageError result;
  std::vector<double> levels, relative;
  const std::vector<float>& objects = reference.aovs.front().values;
  for (std::size_t pixel = 0; pixel < objects.size(); ++pixel) {
    if (objects[pixel] == 0) continue; // background
    ++result.pixels;
    double off_levels = 0, off = 0, size = 0;
    int off_stored = 0;
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
      const double a = frame.radiance_double.values[i], b = reference.radiance_double.values[i];
      off_levels = std::max(off_levels, std::abs(displayed(a) - displayed(b)));
      off = std::max(off, std::abs(a - b));
      size = std::max(size, std::abs(b));
      off_stored = std::max(off_stored, std::abs(frame.rgb8.values[i] - reference.rgb8.values[i]));
    }
    levels.push_back(off_levels);
    if (size > 0) relative.push_back(off / size);
    result.off_by_one += off_stored == 1;
    result.off_by_more += off_stored > 1;
  }
  result.levels = figures(levels);
  result.relative = figures(relative);
  return result;
}

} // namespace refraster::bench
