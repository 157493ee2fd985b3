#pragma once
// How far an image of one precision is from that of another.

#include "bench/measure/results.h"

namespace refraster::bench {

/// Of two frames of the same size, both with levels and radiance_double, and with Aov::object as the reference's first
/// AOV.
ImageError image_error(const Frame& frame, const Frame& reference);

} // namespace refraster::bench
