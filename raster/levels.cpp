#include "raster/levels.h"

#include "raster/parallel.h"
#include "shading/srgb_curve.h"

#include <algorithm>
#include <cmath>

namespace refraster {
namespace {

constexpr double full_scale = 65535;

std::uint16_t level(double value, Transfer transfer) {
  const double in_range = value > 0 ? std::min(value, 1.0) : 0; // NaN is not > 0
  const double encoded = transfer == Transfer::srgb ? srgb_encoded(in_range) : in_range;
  // 2^52 has no bits for fractions: adding it rounds, half to even.
  return static_cast<std::uint16_t>(full_scale * encoded + 0x1p52 - 0x1p52);
}

} // namespace

Image<std::uint16_t> levels16(const Image<double>& values, Transfer transfer, int threads) {
  Image<std::uint16_t> image(values.width, values.height, values.channels);
  const std::size_t row = static_cast<std::size_t>(values.width) * static_cast<std::size_t>(values.channels);
  parallel_for(threads, static_cast<std::size_t>(values.height), [&](std::size_t y, int) {
    for (std::size_t i = y * row; i < (y + 1) * row; ++i) image.values[i] = level(values.values[i], transfer);
  });
  return image;
}

} // namespace refraster
