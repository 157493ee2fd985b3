#pragma once
// Where a pixel is sampled.

#include <array>
#include <cstdint>
#include <span>

namespace refraster {

/// A sample's position in its pixel, in subpixels (1/256 pixel) from the pixel's top left corner.
struct SamplePosition {
  std::int32_t x, y;
};

/// The standard positions of Direct3D 11 (D3D11_STANDARD_MULTISAMPLE_PATTERN) and Vulkan (§ "Multisampling"), given
/// there in sixteenths of a pixel. One sample stands at the centre. Of the sixteen, #12 lies on the pixel's left
/// border and #15 on its top border.
std::span<const SamplePosition> sample_pattern(int samples);

/// 1, 2, 4, 8 or 16.
bool is_sample_count(int samples);

} // namespace refraster
