#include "io/atomic_file.h"
#include "io/image_formats.h"

#include <algorithm>
#include <array>
#include <cmath>

// Radiance RGBE: three mantissas of 8 bits and the exponent of the largest, e: value = mantissa 2^(e - 136). Written
// here and not by stb_image_write, which cuts the mantissas off where they should be rounded, and has no answer to a
// negative value or NaN. Rows are not run-length coded: a first pixel that a reader takes for the mark of a coded row,
// 2 2 below 128, has no mantissa of 128 or more, and is never written.

namespace refraster {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

/// Each channel to the nearest of the 256 steps that the largest leaves. Negative and NaN become 0; beyond 1.7e38, the
/// largest.
Rgbe encode(const float* rgb) {
  std::array<double, 3> value;
  for (std::size_t c = 0; c < 3; ++c)
    value[c] = rgb[c] > 0 ? std::min(static_cast<double>(rgb[c]), 255 * std::ldexp(1.0, 119)) : 0;
  const double largest = std::max({value[0], value[1], value[2]});
  if (largest < std::ldexp(1.0, -128)) return {0, 0, 0, 0};
  int exponent = 0;
  std::frexp(largest, &exponent);                                          // largest in [2^(exponent-1), 2^exponent)
  if (std::nearbyint(std::ldexp(largest, 8 - exponent)) > 255) ++exponent; // rounds up to 256
  Rgbe pixel{0, 0, 0, static_cast<std::uint8_t>(exponent + 128)};
  for (std::size_t c = 0; c < 3; ++c)
    pixel[c] = static_cast<std::uint8_t>(std::nearbyint(std::ldexp(value[c], 8 - exponent)));
  return pixel;
}

} // namespace

void write_hdr(const std::string& path, const Image<float>& image) {
  AtomicFile file(path);
  file.write("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(image.height) + " +X " +
             std::to_string(image.width) + "\n");
  std::vector<Rgbe> row(static_cast<std::size_t>(image.width));
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) row[static_cast<std::size_t>(x)] = encode(image.at(x, y));
    file.write(row.data(), row.size() * sizeof(Rgbe));
  }
  file.commit();
}

} // namespace refraster
