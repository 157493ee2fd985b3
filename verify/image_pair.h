#pragma once
// Two image files, ready to be compared.

#include "raster/memory_budget.h"
#include "verify/compare.h"

#include <string>

namespace refraster {

/// Two images of one size and number of channels, in one unit.
struct ImagePair {
  Image<float> a, b;
  CompareUnit unit = CompareUnit::levels;
};

/// Reads two images. Levels are kept if both have 8 bits a channel; else a level becomes the float nearest to its share
/// of the full scale, l / 255 or l / 65535.
/// Throws InputError if one cannot be read, or if they differ in size, number of channels, or,
/// where both files name them (EXR), names of channels.
ImagePair read_image_pair(const std::string& path_a, const std::string& path_b, const MemoryBudget& memory = {});

} // namespace refraster
