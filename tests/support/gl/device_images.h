#pragma once
// What OpenGL has drawn, as a device's image that is to be judged.

#include "gl/render_gl.h"
#include "verify/verdict/verdict.h"

#include <algorithm>

namespace refraster {

/// Relative error of one rounding to float.
inline constexpr double float_rounding = 0x1p-24;

/// The 8-bit image, with ids and depth where they were read back.
inline DeviceImage in_8_bits(const GlFrame& frame) {
  DeviceImage image;
  image.colour = Image<float>(frame.rgb8.width, frame.rgb8.height, 3);
  std::copy(frame.rgb8.values.begin(), frame.rgb8.values.end(), image.colour.values.begin());
  image.precision = StoredPrecision::integers(255);
  image.ids = frame.ids, image.depth = frame.depth;
  return image;
}

/// The float image, likewise.
inline DeviceImage in_float(const GlFrame& frame) {
  DeviceImage image;
  image.colour = frame.radiance;
  image.full_scale = 1;
  image.precision = StoredPrecision::floats(float_rounding);
  image.ids = frame.ids, image.depth = frame.depth;
  return image;
}

} // namespace refraster
