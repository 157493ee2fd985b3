#pragma once
// What the colours of a heat image mean.

#include "verify/compare/heat_image.h"

#include <vector>

namespace refraster {

/// The heat image of this comparison with a strip below it: black for equal, the ramp with round numbers at the colours
/// that stand for them and their unit (a + at the end where some pixels differ by more), and the colour of what has no
/// difference, if there is any. An image narrower than the strip is filled up with grey on the right; beside a large
/// one the strip is enlarged. Without a difference (ramp_end 0) there is no ramp.
Image<std::uint8_t> with_legend(const Image<std::uint8_t>& heat, const Comparison& found, double ramp_end);

/// The numbers that the legend shows: 0, the end of the ramp, and between them, from its end down, those of 1, 2, 5,
/// 10, 20 ... that have room for a label beside the one before. Rising.
std::vector<double> legend_ticks(double ramp_end, CompareUnit unit);

/// Where on the ramp a difference stands, in [0, 1]: as heat_image.h says.
double ramp_position(double difference, double ramp_end, CompareUnit unit);

} // namespace refraster
