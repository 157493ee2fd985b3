#pragma once
// Which depths are drawn.

#include <limits>

namespace refraster {

/// The least number above 1: a depth z / w is drawn if it is at least -1 and LESS than this, that is, from the near
/// plane up to and including the far plane.
inline constexpr double beyond_far = 1 + std::numeric_limits<double>::epsilon();

} // namespace refraster
