#pragma once
// What the colours of a heat image mean.

#include "verify/heat_image.h"

namespace refraster {

/// The heat image of this comparison with a strip below it: black for equal, the ramp with the differences that its
/// colours stand for and their unit, and the colour of what has no difference, if there is any. An image narrower than
/// the strip is filled up with grey on the right; beside a large one the strip is enlarged.
Image<std::uint8_t> with_legend(const Image<std::uint8_t>& heat, const Comparison& found);

/// The difference that a share t of the ramp stands for; heat_image.h has the inverse.
double difference_at(double t, const Comparison& found);

} // namespace refraster
