#pragma once
// Small images for the page.

#include <refraster/image.h>
#include <refraster/render.h>

#include <cstdint>
#include <string>

namespace refraster::suite {

/// The longer side of a thumbnail, in pixels: three of them stand side by side in a card of the page.
inline constexpr int thumbnail_side = 240;

/// A PNG file as base64: the image if it is small, else means over the pixels that fall on each of its own.
std::string thumbnail_of(const Image<std::uint8_t>& rgb8);

/// Values of which `white` is white, clamped, as levels.
Image<std::uint8_t> levels_of(const Image<float>& values, double white, Transfer transfer);

} // namespace refraster::suite
