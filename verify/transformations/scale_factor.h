#pragma once
// By which constant one image is the other.

#include "verify/transformations/transformations.h"

namespace refraster {

/// The k for which the sum of |b - k a| over all values is least: few values that do not follow move it little, and
/// none if all others follow exactly. Of a million values at most, and only of those that are not cut off. 0 if there
/// is none.
double scale_factor(const StoredImage& a, const StoredImage& b);

} // namespace refraster
