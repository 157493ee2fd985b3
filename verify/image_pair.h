#pragma once
// Two image files, ready to be compared.

#include "raster/image.h"

#include <cstdint>
#include <string>
#include <utility>
#include <variant>

namespace refraster {

/// Two images of one size and number of channels: both of 8 bits, or both as floats.
using ImagePair =
    std::variant<std::pair<Image<std::uint8_t>, Image<std::uint8_t>>, std::pair<Image<float>, Image<float>>>;

/// Reads two images. If only one has 8 bits a channel, its level l becomes the float nearest to l / 255.
/// Throws InputError if one cannot be read, or they differ in size or number of channels.
ImagePair read_image_pair(const std::string& path_a, const std::string& path_b);

} // namespace refraster
