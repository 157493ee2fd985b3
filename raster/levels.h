#pragma once
// Radiance to whole numbers of 16 bits. Those of 8 bits are made while tiles are resolved (raster/resolve/resolve.h).

#include <refraster/render.h>

#include <cstddef>
#include <cstdint>

namespace refraster {

/// Of each value 65535 times what `transfer` makes of it, clamped to [0, 1], rounded to the nearest integer, half to even;
/// 0 for NaN. In double. `to` has room for as many.
void levels16(const double* values, std::size_t count, Transfer transfer, std::uint16_t* to);

} // namespace refraster
