#pragma once
// One visible triangle at one pixel: what is interpolated, what is read, and every term of its radiance.

#include "raster/frame_context.h"
#include "verify/explain/pixel_story.h"

#include <cstdint>

namespace refraster {

/// The triangle of that number in the frame, for people.
NamedTriangle named_triangle(const FrameContext& context, std::uint32_t number);

/// Shaded at the centre of pixel (x, y), in double; `samples` is how many of the pixel's see it.
FragmentStory fragment_story(const FrameContext& context, std::uint32_t number, int x, int y, int samples);

/// What it would be if it were seen there.
Double3 fragment_radiance(const FrameContext& context, std::uint32_t number, int x, int y);

/// Perspective-correct weights of the corners at (x, y), in subpixels, in the order of the mesh.
std::array<double, 3> corner_weights(const FrameContext& context, std::uint32_t number, std::int32_t x, std::int32_t y);

/// The terms at (x, y), in subpixels, in 60 digits.
ExactTerms exact_terms(const FrameContext& context, std::uint32_t number, std::int32_t x, std::int32_t y);

} // namespace refraster
