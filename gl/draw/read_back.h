#pragma once
// What was drawn comes back. Images have the top row first, whereas OpenGL counts rows from the bottom.

#include <refraster/image.h>

#include "gl/context/target.h"

#include <cstdint>

namespace refraster {

/// Red, green and blue; of several samples the driver's resolve. The target is the current framebuffer before and
/// after, here and below.
Image<std::uint8_t> read_rgb8(const GlApi& gl, const GlTarget& target);
Image<float> read_radiance(const GlApi& gl, const GlTarget& target);

/// One sample of each pixel, as it is stored: the first `channels` of the colours of a float target, or window depth.
Image<float> read_sample(const GlApi& gl, const GlTarget& target, int sample, int channels);
Image<float> read_sample_depth(const GlApi& gl, const GlTarget& target, int sample);

} // namespace refraster
