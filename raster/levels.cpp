#include "raster/levels.h"

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

void levels16(const double* values, std::size_t count, Transfer transfer, std::uint16_t* to) {
  std::transform(values, values + count, to, [transfer](double value) { return level(value, transfer); });
}

} // namespace refraster
