#pragma once
// By how many pixels one image may lie beside the other.

#include "verify/transformations/transformations.h"

#include <vector>

namespace refraster {

/// b is so many pixels to the right of a, and down.
struct PixelShift {
  int x = 0, y = 0;
};

/// How far is looked, along each axis, and at most half of the image.
inline constexpr int max_shift = 128;

/// The shifts under which pixels of b that stand out from their neighbours agree best with a, the best first; never
/// none at all. At most eight, each to be judged over the whole image.
std::vector<PixelShift> likely_shifts(const StoredImage& a, const StoredImage& b, double limit);

} // namespace refraster
