#pragma once
// Colours for kinds of pixels.

#include "verify/compare/heat_image.h"

#include <array>

namespace refraster {

/// Eleven colours, from what needs no look to what does: dark for what is right to the last bit, and at the end
/// vermilion. Any two are told apart with each of the three common colour vision deficiencies too: a test simulates
/// them. They are the same on light and on dark pages.
inline constexpr std::array<Rgb8, 11> verdict_colours = {{
    {0x2b, 0x33, 0x3c}, // charcoal
    {0x70, 0x71, 0x87}, // grey
    {0x26, 0x5e, 0xff}, // blue
    {0x68, 0xe2, 0xf9}, // sky
    {0x2e, 0xa0, 0x6d}, // green
    {0x60, 0x00, 0x80}, // purple
    {0xf7, 0xd5, 0x30}, // yellow
    {0xc4, 0x85, 0xff}, // violet
    {0xf5, 0xff, 0xe5}, // white
    {0x85, 0x3b, 0x1b}, // brown
    {0xf1, 0x4d, 0x10}, // vermilion
}};

} // namespace refraster
