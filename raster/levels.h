#pragma once
// Radiance to whole numbers of 16 bits. Those of 8 bits are made while tiles are resolved (raster/resolve/resolve.h).

#include <refraster/image.h>
#include <refraster/render.h>

#include <cstdint>

namespace refraster {

/// Of each value 65535 times what `transfer` makes of it, clamped to [0, 1], rounded to the nearest integer, half to even;
/// 0 for NaN. In double; the same for any number of threads. Throws std::bad_alloc.
Image<std::uint16_t> levels16(const Image<double>& values, Transfer transfer, int threads);

} // namespace refraster
