#pragma once
// Images that a right device may make: a level that lies between two of them is explained, without any bounds.

#include "verify/verdict/verdict.h"

namespace refraster {

/// Radiance of two frames, 3 channels: all filtered texels lower, and higher, by as much as the device's filter may
/// err.
struct Witnesses {
  Image<float> low, high;
};

/// Nothing where no texture is filtered, or the filter is exact: they would be the reference.
std::optional<Witnesses> texel_witnesses(const Scene& scene, const RenderOptions& options,
                                         const DeviceProfile& profile);

} // namespace refraster
